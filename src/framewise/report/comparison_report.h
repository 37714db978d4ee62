// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "framewise/geometry/trajectory.h"
#include "framewise/report/comparison.h"
#include "framewise/report/run_report.h"

namespace framewise {

// All that the page about a comparison is made of.
struct ComparisonReport {
  Comparison comparison;
  std::string command, machine;          // as they were; empty where not known
  std::vector<Trajectory> truths;        // of each data set; empty where there is none
  std::vector<Trajectory> trajectories;  // of each row, in its truth's world; empty where there is none
  std::vector<std::string> missing;      // what could not be read, and why: a sentence each
};

std::vector<Hint> comparison_hints(const ComparisonReport& report);

// A name for a file, and the figure: bars of the errors, error over time cost, and the best rows'
// trajectories.
std::vector<std::pair<std::string, std::string>> comparison_figure_files(const ComparisonReport& report);

// The page: one HTML file that needs nothing else.
std::string comparison_page(const ComparisonReport& report);

}  // namespace framewise
