// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

namespace framewise {

// What is said about a list of errors; all in the errors' unit but sse, which is in its square.
struct Statistics {
  double rmse = 0;
  double mean = 0;
  double median = 0;  // of an even count: the mean of the middle two
  double std = 0;     // of the population (divided by n, not n - 1), as evo, TUM's tools and numpy have it
  double min = 0;
  double max = 0;
  double sse = 0;  // sum of the squares
  std::size_t count = 0;
};

// Throws std::invalid_argument for no errors and for one that is not finite: a mean of them would be a lie.
Statistics statistics(std::span<const double> errors);

// Median of any order of values, as above.
double median(std::span<const double> values);

}  // namespace framewise
