// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framewise/evaluation/paired_comparison.h"
#include "framewise/evaluation/spread.h"

namespace framewise {

// A relative error of a row: its RMSE over the frames.
struct ComparedError {
  Spread rmse;                              // over the repeats
  std::optional<Interval> interval;         // of the median over the repeats, by bootstrap over the frames
  bool is_best = false;                     // the least median of the data set
  std::optional<PairedDifference> to_best;  // this row's error - the best row's; unset: other frames
};

// What the frames of a row cost, on one core.
struct ComparedTimes {
  // Milliseconds a frame, means over the frames. The first three are those of the archive's making.
  std::optional<double> load_ms, features_ms, match_ms;
  double solve_ms = 0;
  std::optional<Interval> frames_per_second;  // of the slowest and the fastest frame, loading not counted
  std::optional<double> mean_frames_per_second;
};

// What others reported of the same method and features on this recording.
struct PublishedResult {
  std::optional<double> ate, rpe_translation_mm, rpe_rotation_deg;  // RMSE (m, mm, degrees)
  std::string outcome;                                              // ok, or why there are no figures
};

// The errors of a row, where there are any.
struct ComparedErrors {
  std::string alignment;
  double delta = 1;
  std::string unit;
  Spread ate;        // RMSE (m)
  Spread direction;  // RMSE of the distance between unit vectors along the steps, 0 to 2
  Spread coverage;   // share of the frames that the truth judges
  ComparedError rpe_translation_mm, rpe_rotation_deg;
};

// A method with features on a data set.
struct ComparisonRow {
  std::string dataset, method, features;
  std::vector<std::pair<std::string, std::string>> options;  // of `run`, resolved
  std::size_t repeats = 0, failed = 0;
  std::string failure;    // why the first repeat that failed did; empty where none did
  std::string no_errors;  // why there are no errors, in a few words; empty where there are
  std::optional<ComparedErrors> errors;
  std::optional<Spread> measured;                        // share of the frames whose motion was measured
  std::vector<std::pair<std::string, Spread>> statuses;  // frames of each status
  std::optional<Spread> missing_pairs;                   // asked of the archive after a loss in vain
  std::optional<ComparedTimes> times;
  std::optional<PublishedResult> published;
  std::string folder;  // of its runs, in the comparison's; likewise below
};

struct ComparedDataset {
  std::string name, path, format, fingerprint, folder;
  std::size_t frames = 0, frames_with_depth = 0, frames_with_truth = 0;
  // Of the truth at the frames, and what a camera that never moved scores (RMSE).
  std::optional<double> path_length, static_ate, static_rpe_translation_mm, static_rpe_rotation_deg;
};

struct Comparison {
  std::string version, grid;
  std::uint64_t seed = 0;
  std::size_t repeats = 0;
  PairedOptions statistics;
  bool has_published = false;  // figures of others were given
  std::vector<ComparedDataset> datasets;
  std::vector<ComparisonRow> rows;  // data set by data set
};

}  // namespace framewise
