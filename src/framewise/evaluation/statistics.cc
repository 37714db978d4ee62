// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace framewise {

double median(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("median: values is empty, expected one or more");
  std::vector<double> sorted(values.begin(), values.end());
  const std::size_t half = sorted.size() / 2;
  std::nth_element(sorted.begin(), sorted.begin() + half, sorted.end());
  if (sorted.size() % 2 == 1) return sorted[half];
  return 0.5 * (*std::max_element(sorted.begin(), sorted.begin() + half) + sorted[half]);
}

Statistics statistics(std::span<const double> errors) {
  if (errors.empty()) throw std::invalid_argument("statistics: errors is empty, expected one or more");
  Statistics s;
  s.count = errors.size();
  s.min = s.max = errors[0];
  double sum = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double e = errors[i];
    if (!std::isfinite(e))
      throw std::invalid_argument("statistics: errors[" + std::to_string(i) + "] is " + std::to_string(e) +
                                  ", expected a finite number");
    sum += e;
    s.sse += e * e;
    s.min = std::min(s.min, e);
    s.max = std::max(s.max, e);
  }
  const double n = static_cast<double>(errors.size());
  s.mean = sum / n;
  s.rmse = std::sqrt(s.sse / n);
  double squares = 0;
  for (const double e : errors) squares += (e - s.mean) * (e - s.mean);
  s.std = std::sqrt(squares / n);
  s.median = median(errors);
  return s;
}

}  // namespace framewise
