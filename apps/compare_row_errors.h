// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framewise/evaluation/evaluation.h"
#include "framewise/report/comparison.h"

namespace framewise::apps {

// A relative error of a row's repeats, frame by frame.
struct FrameErrors {
  std::vector<std::vector<double>> of_repeats;  // all of one length
  // Root of the mean square of these frames, the median of the repeats.
  double median_rmse(std::span<const std::size_t> frames) const;
};

// What the repeats of a row that have errors scored.
struct RowErrors {
  std::string alignment, unit;
  double delta = 1;
  std::vector<double> ate, direction, coverage;
  FrameErrors translation_mm, rotation_deg;

  bool empty() const { return ate.empty(); }
  void add(const Trajectory& truth, const Trajectory& estimate, const std::string& alignment_name);
};

// Fills `errors` of the rows of one data set: spreads over the repeats, intervals over the frames, and the
// comparison of each row with the best. errors[i] is of rows[i].
void summarise_errors(std::span<ComparisonRow> rows, const std::vector<RowErrors>& errors,
                      const PairedOptions& options);

}  // namespace framewise::apps
