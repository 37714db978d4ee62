// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_comparison.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "framewise/evaluation/trajectory_alignment.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/report/comparison_json.h"
#include "framewise/report/record_fields.h"
#include "report_files.h"

namespace framewise::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const fs::path& path) {
  std::ifstream file(path);
  return Json::parse(file, nullptr, false);
}

Trajectory trajectory_of(const fs::path& path) {
  return read_trajectory(path, TrajectoryFormat::kTum).trajectory;
}

// As it was judged; as it is where it cannot be.
Trajectory laid_onto(const Trajectory& truth, const Trajectory& estimate, const ComparisonRow& row) {
  if (truth.size() < 2 || !row.errors) return estimate;
  AssociationOptions association;
  association.max_difference = 1e-6;
  const auto pair = associate(truth, estimate, association);
  return transformed(align(pair, alignment_from_name(row.errors->alignment)), estimate);
}

class TrajectoryReader {
 public:
  TrajectoryReader(const fs::path& folder, ComparisonReport& report) : folder_(folder), report_(report) {}

  void read() {
    for (const ComparedDataset& dataset : report_.comparison.datasets)
      report_.truths.push_back(
          dataset.folder.empty() ? Trajectory() : read_if_there(folder_ / dataset.folder / "truth.tum"));
    for (const ComparisonRow& row : report_.comparison.rows) report_.trajectories.push_back(of_row(row));
  }

 private:
  Trajectory read_if_there(const fs::path& path) {
    if (!fs::exists(path)) return {};
    try {
      return trajectory_of(path);
    } catch (const InputError& error) {
      report_.missing.push_back(error.what());
      return {};
    }
  }

  const Trajectory& truth_of(const ComparisonRow& row) const {
    for (std::size_t i = 0; i < report_.truths.size(); ++i)
      if (report_.comparison.datasets[i].name == row.dataset) return report_.truths[i];
    throw InputError(folder_ / "results.json", 0, "dataset", row.dataset, "a data set that is listed");
  }

  // Of the first repeat that is there.
  Trajectory of_row(const ComparisonRow& row) {
    const Trajectory& truth = truth_of(row);
    if (row.folder.empty() || row.failed == row.repeats) return {};
    for (std::size_t i = 0; i < row.repeats; ++i) {
      const std::string seed = fmt::format("seed_{}", report_.comparison.seed + i);
      const Trajectory estimate = read_if_there(folder_ / row.folder / seed / "trajectory.tum");
      if (estimate.empty()) continue;
      try {
        return laid_onto(truth, estimate, row);
      } catch (const std::invalid_argument&) {
        continue;  // it never moved, or its times are of another truth
      }
    }
    return {};
  }

  const fs::path& folder_;
  ComparisonReport& report_;
};

}  // namespace

bool is_comparison_folder(const fs::path& folder) { return fs::exists(folder / "results.json"); }

ComparisonReport read_comparison(const fs::path& folder) {
  ComparisonReport report;
  try {
    report.comparison = comparison_from_json(json_of(folder / "results.json"));
  } catch (const Json::exception& error) {
    throw InputError(folder / "results.json", 0, "", error.what(), "what `compare` writes");
  }
  const Json invocation = json_of(folder / kReportData / "invocation.json");
  report.command = record_text(invocation, "/command");
  report.machine = record_text(invocation, "/machine");
  TrajectoryReader(folder, report).read();
  return report;
}

}  // namespace framewise::apps
