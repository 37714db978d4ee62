// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/frame_rate.h"

#include <algorithm>
#include <cmath>

#include "framewise/evaluation/statistics.h"

namespace framewise {

FrameRate frame_rate(std::span<const double> times) {
  FrameRate rate;
  if (times.size() < 2) return rate;
  std::vector<double> steps(times.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = times[i + 1] - times[i];
  rate.median_step = median(steps);
  rate.longest_step = *std::max_element(steps.begin(), steps.end());
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i] > 2.5 * rate.median_step) rate.gaps.push_back({times[i], steps[i]});
  for (double& step : steps) step = std::abs(step - rate.median_step);
  rate.jitter = median(steps);
  return rate;
}

const FrameRate::Gap* FrameRate::pause() const {
  const auto longest = std::max_element(gaps.begin(), gaps.end(),
                                        [](const Gap& a, const Gap& b) { return a.length < b.length; });
  if (longest == gaps.end() || longest->length < 10 || longest->length < 100 * median_step) return nullptr;
  return &*longest;
}

}  // namespace framewise
