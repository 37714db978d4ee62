// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/odometry/step.h"

namespace framewise {

// One constant length for all steps, from depth in the first pair of frames alone: the first step whose
// translation is measured and whose points have depth. Before it a step of little parallax counts as one that
// only turned, which needs no length; a step with a measured translation and no depth has none (no-depth).
class FirstPairScale {
 public:
  // Steps in the order of the frames, t of length 1; the answer is metric.
  Step apply(Step step);

  std::optional<double> length() const { return length_; }  // m; empty until a pair told it

 private:
  std::optional<double> length_;
};

}  // namespace framewise
