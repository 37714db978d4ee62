// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step_from_estimate.h"

namespace framewise {

Step with_estimate(Step step, const std::optional<Estimate>& estimate, int min_inliers) {
  if (!estimate || static_cast<int>(estimate->num_inliers) < min_inliers) return step;
  step.inliers = static_cast<int>(estimate->num_inliers);
  step.iterations = estimate->iterations;
  step.iterations_theory = estimate->iterations_theory;
  step.cam2_from_cam1 = estimate->cam2_from_cam1;
  step.covariance = estimate->covariance;
  switch (estimate->kind) {
    case EstimateKind::kFull:
      step.status = Status::kOk;
      break;
    case EstimateKind::kLowParallax:
      step.status = Status::kLowParallax;
      break;
    case EstimateKind::kRotationOnly:
      step.status = Status::kRotationOnly;
      step.cam2_from_cam1.t.setZero();
      break;
  }
  return step;
}

}  // namespace framewise
