// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_results.h"

#include <fmt/format.h>

#include <fstream>
#include <numeric>

#include "compare_row_errors.h"
#include "framewise/io/csv_table.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/odometry/status.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// What one repeat of a row left.
struct RunRead {
  Json record;  // run.json
  std::vector<double> solve_ms;
};

Json read_run_record(const fs::path& folder) {
  std::ifstream file(folder / "run.json");
  return Json::parse(file);
}

std::vector<double> read_column(const fs::path& frames_csv, const char* name) {
  const CsvTable table(frames_csv);
  std::vector<double> values;
  for (std::size_t row = 0, column = table.column(name); row < table.num_rows(); ++row)
    values.push_back(table.number(row, column).value_or(0));
  return values;
}

double mean(const std::vector<double>& values) {
  return values.empty()
             ? 0
             : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> mean_over_runs(const std::vector<RunRead>& runs) {
  std::vector<double> sum(runs.front().solve_ms.size());
  for (const RunRead& run : runs)
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += run.solve_ms[i] / static_cast<double>(runs.size());
  return sum;
}

// The first frame is not matched with any; its time would be that of no step.
ComparedTimes times_of(const PlannedArchive& archive, const std::vector<RunRead>& runs) {
  ComparedTimes times;
  std::vector<double> frames = mean_over_runs(runs);
  times.solve_ms = mean(frames);
  if (archive.is_given) return times;
  const fs::path csv = archive.job.folder / "frames.csv";
  const std::vector<double> features = read_column(csv, "features_ms"), match = read_column(csv, "match_ms");
  times.load_ms = mean(read_column(csv, "load_ms"));
  times.features_ms = mean(features);
  times.match_ms = mean(match);
  if (frames.size() < 2 || features.size() != frames.size()) return times;
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] += features[i] + match[i];
  frames.erase(frames.begin());
  const auto [least, most] = std::minmax_element(frames.begin(), frames.end());
  if (*least <= 0) return times;
  times.frames_per_second = Interval{1e3 / *most, 1e3 / *least};
  times.mean_frames_per_second = 1e3 / mean(frames);
  return times;
}

Spread spread_over(const std::vector<RunRead>& runs, const std::function<double(const Json&)>& value) {
  std::vector<double> values;
  for (const RunRead& run : runs) values.push_back(value(run.record));
  return spread(values);
}

void add_counts(ComparisonRow& row, const std::vector<RunRead>& runs) {
  row.measured = spread_over(runs, [](const Json& run) { return run["measured"].get<double>(); });
  row.missing_pairs =
      spread_over(runs, [](const Json& run) { return run["archive"]["missing_pairs"].get<double>(); });
  for (const Status status : kAllStatuses) {
    const std::string status_name(name(status));
    row.statuses.emplace_back(status_name, spread_over(runs, [&](const Json& run) {
                                return run["statuses"][status_name].get<double>();
                              }));
  }
}

std::string option_of(const PlannedRow& row, const std::string& option) {
  for (const auto& [name, value] : row.options)
    if (name == option) return value;
  return "";
}

// What --error default means.
std::string resolved_error(const PlannedRow& row) {
  const std::string error = option_of(row, "error"), solver = option_of(row, "solver");
  if (error != "default") return error;
  return solver == "kabsch" ? "point-to-point" : solver == "p3p" ? "reprojection" : "sampson";
}

std::optional<PublishedResult> published_result(const std::vector<PublishedFigures>& published,
                                                const std::string& dataset, const PlannedRow& row) {
  const std::string detector = option_of(row, "detector");
  std::string features = detector;
  std::transform(features.begin(), features.end(), features.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  for (const PublishedFigures& p : published)
    if (is_of_sequence(dataset, p.sequence) && p.solver == option_of(row, "solver") &&
        p.scale == option_of(row, "scale") && p.error == resolved_error(row) && p.features == features &&
        option_of(row, "descriptor") == detector) {
      PublishedResult result{p.ate, p.rpe_translation, p.rpe_rotation_deg, p.outcome};
      if (result.rpe_translation_mm) *result.rpe_translation_mm *= 1e3;
      return result;
    }
  return std::nullopt;
}

ComparedDataset dataset_of(const PlannedDataset& planned, const Trajectory& truth) {
  const Recording& recording = planned.recording;
  ComparedDataset dataset;
  dataset.name = planned.label;
  dataset.path = recording.path.string();
  dataset.folder = "datasets/" + planned.folder.filename().string();
  dataset.format = recording.from.dataset_format;
  dataset.fingerprint = recording.from.dataset_fingerprint;
  dataset.frames = recording.size();
  dataset.frames_with_depth = recording.from.frames_with_depth;
  dataset.frames_with_truth = truth.size();
  if (truth.size() < 2) return dataset;
  Trajectory still;
  for (const double time : truth.times) still.add(time, Pose{});
  const Evaluation e = evaluate(truth, still, {});
  dataset.path_length = e.path_length;
  dataset.static_ate = e.static_baseline.ate;
  if (const auto rpe = e.static_baseline.rpe_translation) dataset.static_rpe_translation_mm = 1e3 * *rpe;
  dataset.static_rpe_rotation_deg = e.static_baseline.rpe_rotation_deg;
  return dataset;
}

// Of all seeds, in the comparison's: rows/DATASET/FEATURES/METHOD.
std::string folder_of(const PlannedRow& row) {
  const fs::path method = row.runs.front().folder.parent_path(), features = method.parent_path();
  return (fs::path("rows") / features.parent_path().filename() / features.filename() / method.filename())
      .string();
}

class Collector {
 public:
  Collector(Comparison& comparison, const ComparePlan& plan, const std::map<fs::path, JobOutcome>& outcomes,
            const std::vector<PublishedFigures>& published)
      : comparison_(comparison), plan_(plan), outcomes_(outcomes), published_(published) {}

  void add_dataset(std::size_t index) {
    const PlannedDataset& planned = plan_.datasets[index];
    const Trajectory truth =
        planned.recording.has_truth()
            ? read_trajectory(planned.folder / "truth.tum", TrajectoryFormat::kTum).trajectory
            : Trajectory();
    comparison_.datasets.push_back(dataset_of(planned, truth));
    const std::size_t first = comparison_.rows.size();
    std::vector<RowErrors> errors;
    for (const PlannedRow& row : plan_.rows)
      if (row.dataset == index) errors.push_back(add_row(row, truth));
    summarise_errors(std::span(comparison_.rows).subspan(first), errors, comparison_.statistics);
  }

 private:
  RowErrors add_row(const PlannedRow& planned, const Trajectory& truth) {
    ComparisonRow& row = comparison_.rows.emplace_back();
    row.dataset = plan_.datasets[planned.dataset].label;
    row.method = planned.method;
    row.features = planned.features;
    row.options = planned.options;
    row.folder = folder_of(planned);
    row.published =
        published_result(published_, plan_.datasets[planned.dataset].recording.from.dataset_name, planned);

    RowErrors errors;
    std::vector<RunRead> runs;
    for (const PlannedJob& job : planned.runs) {
      ++row.repeats;
      const JobOutcome& outcome = outcomes_.at(job.folder);
      if (!outcome.message.empty()) {
        ++row.failed;
        if (row.failure.empty()) row.failure = outcome.message;
        continue;
      }
      runs.push_back({read_run_record(job.folder), read_column(job.folder / "frames.csv", "step_ms")});
      const Json& evaluation = runs.back().record["evaluation"];
      if (evaluation.is_null())
        row.no_errors = truth.size() < 2 ? "no truth" : "an estimate that never moved has no scale";
      else
        errors.add(truth, read_trajectory(job.folder / "trajectory.tum", TrajectoryFormat::kTum).trajectory,
                   evaluation["alignment"].get<std::string>());
    }
    if (!errors.empty()) row.no_errors.clear();
    if (runs.empty()) return errors;
    add_counts(row, runs);
    row.times = times_of(plan_.archives[planned.archive], runs);
    return errors;
  }

  Comparison& comparison_;
  const ComparePlan& plan_;
  const std::map<fs::path, JobOutcome>& outcomes_;
  const std::vector<PublishedFigures>& published_;
};

}  // namespace

void fill_comparison(Comparison& comparison, const ComparePlan& plan,
                     const std::map<fs::path, JobOutcome>& outcomes,
                     const std::vector<PublishedFigures>& published) {
  Collector collector(comparison, plan, outcomes, published);
  for (std::size_t i = 0; i < plan.datasets.size(); ++i) collector.add_dataset(i);
}

}  // namespace framewise::apps
