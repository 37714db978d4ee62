// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/spread.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace framewise {
namespace {

double quantile_of_sorted(std::span<const double> sorted, double p) {
  const double h = static_cast<double>(sorted.size() - 1) * p;
  const auto below = static_cast<std::size_t>(h);
  if (below + 1 >= sorted.size()) return sorted.back();
  return sorted[below] + (h - std::floor(h)) * (sorted[below + 1] - sorted[below]);
}

std::vector<double> sorted_values(std::span<const double> values, const std::string& caller) {
  if (values.empty()) throw std::invalid_argument(caller + ": values is empty, expected one or more");
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace

double quantile(std::span<const double> values, double p) {
  if (!(p >= 0 && p <= 1))
    throw std::invalid_argument("quantile: p is " + std::to_string(p) + ", expected 0 to 1");
  return quantile_of_sorted(sorted_values(values, "quantile"), p);
}

Spread spread(std::span<const double> values) {
  const std::vector<double> sorted = sorted_values(values, "spread");
  return {quantile_of_sorted(sorted, 0.5), quantile_of_sorted(sorted, 0.25), quantile_of_sorted(sorted, 0.75),
          sorted.size()};
}

}  // namespace framewise
