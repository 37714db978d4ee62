// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "framewise/evaluation/metric.h"

namespace framewise {

// What evo writes over its figures and beside their axis. Its programs take figures for comparable where the
// titles are equal, so what evo knows is said in its words:
//   RPE w.r.t. translation part (m)
//   for delta = 1.0 (m) using all pairs
//   (with SE(3) Umeyama alignment)
struct EvoLabels {
  std::string title;
  std::string label;
};

EvoLabels evo_labels(const Evaluation& evaluation, const Metric& metric);

}  // namespace framewise
