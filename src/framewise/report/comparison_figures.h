// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "framewise/report/comparison_report.h"
#include "framewise/report/plot.h"

namespace framewise {

// What is drawn of one data set.
struct DatasetFigures {
  std::vector<BarPlot> bars;  // ATE, RPE translation and rotation
  Plot cost;                  // error over milliseconds a frame, with the rows that none beats in both
  std::vector<Plot> maps;     // from three sides; rows are found by their number as key, the best is drawn
};
DatasetFigures comparison_figures(const ComparisonReport& report, std::size_t dataset);

// "Kabsch with ORB".
std::string row_label(const ComparisonRow& row);

// The points of a trajectory that a reader can tell apart, from first to last.
std::vector<std::size_t> drawn_points(const Trajectory& trajectory);

}  // namespace framewise
