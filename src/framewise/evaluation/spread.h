// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

namespace framewise {

// The value below which the share p of the values lies, linear between the two it falls between:
//   x(0), ..., x(n-1) sorted, h = (n - 1) p: x(floor h) + (h - floor h) (x(floor h + 1) - x(floor h))
// Definition 7 of Hyndman and Fan, Sample Quantiles in Statistical Packages, The American Statistician 1996;
// numpy's. Throws std::invalid_argument for no values and for p outside [0, 1].
double quantile(std::span<const double> values, double p);

// How a figure varies from repeat to repeat.
struct Spread {
  double median = 0;
  double first_quartile = 0;
  double third_quartile = 0;
  std::size_t count = 0;
};

// Throws std::invalid_argument for no values.
Spread spread(std::span<const double> values);

}  // namespace framewise
