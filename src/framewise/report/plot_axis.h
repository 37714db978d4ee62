// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

namespace framewise {

// One axis of a plot: which values it shows and where on the paper.
struct PlotAxis {
  double low = 0, high = 1;      // values; of a logarithmic axis both positive
  double start = 0, length = 1;  // on the paper, length negative where values grow towards the start
  bool is_log = false;

  double at(double value) const;  // NaN for what the axis cannot show
  std::vector<double> ticks() const;
};

// An axis that shows all values that are finite (and positive, if logarithmic), with air at both ends; a
// linear one of values of one sign begins at 0 where `from_zero`. Empty lists show 0 to 1 (1 to 10).
PlotAxis axis_of(std::span<const double> values, bool is_log, bool from_zero);

// A tick's number, no longer than it needs.
std::string tick_text(double value);

}  // namespace framewise
