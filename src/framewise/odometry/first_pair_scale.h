// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/odometry/step.h"

namespace framewise {

// One constant length for all steps, from depth in the first pair of frames alone: the first step whose
// translation is measured and whose points have depth. What comes before it and needs a length has none
// (no-depth); a step that only turned needs none.
class FirstPairScale {
 public:
  // Steps in the order of the frames, t of length 1; the answer is metric.
  Step apply(Step step);

  std::optional<double> length() const { return length_; }  // m; empty until a pair told it

 private:
  std::optional<double> length_;
};

}  // namespace framewise
