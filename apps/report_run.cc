// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_run.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <set>

#include "frame_keeper.h"
#include "framewise/io/csv_table.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/report/record_fields.h"
#include "run_record.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// What a file lacks is said once, and the page is made of the others.
template <typename Read>
void try_to(RunReport& report, Read&& read) {
  try {
    read();
  } catch (const std::exception& error) {
    report.missing.push_back(error.what());
  }
}

// frames.csv by the names of its columns: others may stand there as well, and any may be missing.
class FrameTable {
 public:
  explicit FrameTable(const fs::path& path) : table_(path) {}

  std::vector<ReportedFrame> frames() {
    std::vector<ReportedFrame> frames(table_.num_rows());
    for (const auto& [name, member] : kNumbers) {
      const auto column = column_of(name);
      for (std::size_t i = 0; i < frames.size(); ++i)
        frames[i].*member = column ? number(i, *column, name) : kNaN;
    }
    const auto status = column_of("status");
    for (std::size_t i = 0; i < frames.size(); ++i)
      frames[i].status = status ? table_.text(i, *status) : "unknown";
    return frames;
  }

  std::vector<std::string> complaints() const {
    std::vector<std::string> sentences;
    for (const std::string& name : absent_)
      sentences.push_back(fmt::format("frames.csv has no column {}.", name));
    for (const std::string& name : not_finite_)
      sentences.push_back(fmt::format(
          "frames.csv has values in column {} that are no finite numbers; figures have gaps there.", name));
    return sentences;
  }

 private:
  static constexpr std::array<std::pair<const char*, double ReportedFrame::*>, 8> kNumbers = {
      {{"time", &ReportedFrame::time},
       {"matches", &ReportedFrame::matches},
       {"inliers", &ReportedFrame::inliers},
       {"parallax_deg", &ReportedFrame::parallax_deg},
       {"load_ms", &ReportedFrame::load_ms},
       {"features_ms", &ReportedFrame::features_ms},
       {"match_ms", &ReportedFrame::match_ms},
       {"step_ms", &ReportedFrame::step_ms}}};

  std::optional<std::size_t> column_of(const std::string& name) {
    const auto found = table_.find(name);
    if (!found) absent_.push_back(name);
    return found;
  }

  double number(std::size_t row, std::size_t column, const std::string& name) {
    try {
      return table_.number(row, column).value_or(kNaN);
    } catch (const InputError&) {
      not_finite_.insert(name);
      return kNaN;
    }
  }

  CsvTable table_;
  std::vector<std::string> absent_;
  std::set<std::string> not_finite_;
};

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path, 0, "", "no file that can be read", "the record of a run");
  Json record = Json::parse(file, nullptr, false);
  if (!record.is_object()) throw InputError(path, 0, "", "no JSON object", "the record of a run");
  return record;
}

Trajectory read_tum(const fs::path& path) { return read_trajectory(path, TrajectoryFormat::kTum).trajectory; }

// The figures once more with what they are made of, as the run's record says they were made.
Evaluation evaluate_again(const RunReport& report, const Trajectory& estimate) {
  EvaluationOptions options;
  options.association.max_difference = 1e-6;
  const Json& record = report.record;
  if (const auto alignment = record_text(record, "/evaluation/alignment"); !alignment.empty())
    options.alignment = alignment_from_name(alignment);
  else if (record_text(record, "/options/scale") == "none")
    options.alignment = Alignment::kSim3;
  if (const auto delta = record_number(record, "/evaluation/delta")) options.relative.delta = *delta;
  if (const auto unit = record_text(record, "/evaluation/unit"); !unit.empty())
    options.relative.unit = delta_unit_from_name(unit);
  return evaluate(report.truth, estimate, options);
}

void read_truth(const fs::path& folder, RunReport& report) {
  const fs::path path = folder / kReportData / "truth.tum";
  if (!fs::exists(path)) {
    report.missing.push_back(
        report.record.contains("evaluation") && !report.record["evaluation"].is_null()
            ? "The truth was not kept beside this run (it was made with --no-report): no errors over time."
            : "There is no truth beside this recording: nothing can be said about errors.");
    return;
  }
  report.truth = read_tum(path);
  if (report.truth.size() < 2 || report.estimate.size() < 2) {
    report.missing.push_back(
        fmt::format("{} poses of the truth and {} of the estimate are too few to evaluate; it takes two.",
                    report.truth.size(), report.estimate.size()));
    return;
  }
  try {
    report.evaluation = evaluate_again(report, report.estimate);
    if (!report.final.empty()) report.final_evaluation = evaluate_again(report, report.final);
  } catch (const std::invalid_argument& error) {
    report.missing.push_back(fmt::format("Nothing could be evaluated: {}.", error.what()));
  }
}

}  // namespace

bool is_run_folder(const fs::path& folder) {
  return fs::exists(folder / "run.json") || fs::exists(folder / "frames.csv");
}

RunReport read_run(const fs::path& folder) {
  RunReport report;
  report.record = Json::object();
  try_to(report, [&] { report.record = read_json(folder / "run.json"); });
  try_to(report, [&] {
    FrameTable table(folder / "frames.csv");
    report.frames = table.frames();
    for (const std::string& sentence : table.complaints()) report.missing.push_back(sentence);
  });
  try_to(report, [&] { report.estimate = read_tum(folder / "trajectory.tum"); });
  if (fs::exists(folder / "trajectory_final.tum"))
    try_to(report, [&] {
      const Trajectory final = read_tum(folder / "trajectory_final.tum");
      if (has_moved(report.estimate, final)) report.final = final;
    });
  try_to(report, [&] { read_truth(folder, report); });
  try_to(report, [&] { read_kept_frames(folder / kReportData, report); });

  report.command = record_text(report.record, "/command");
  report.machine = record_text(report.record, "/machine");
  report.title = record_text(report.record, "/dataset/name");
  if (report.title.empty()) report.title = fs::absolute(folder).lexically_normal().filename().string();
  if (report.frames.size() == 1)
    report.missing.push_back("The recording has one frame: there is no motion to show.");
  return report;
}

}  // namespace framewise::apps
