// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step.h"

#include "framewise/odometry/step_from_bearings.h"
#include "framewise/odometry/step_from_points.h"

namespace framewise {

Step estimate_step(const Correspondences& correspondences, const Camera& camera,
                   const OdometryOptions& options, std::uint64_t seed, const StepKnowledge& known) {
  Step step;
  step.matches = static_cast<int>(correspondences.size());
  if (options.needs_depth() && !correspondences.has_depth) {
    step.status = Status::kNoDepth;
    return step;
  }
  return options.is_metric() ? step_from_points(step, correspondences, camera, options, seed)
                             : step_from_bearings(step, correspondences, camera, options, seed, known);
}

}  // namespace framewise
