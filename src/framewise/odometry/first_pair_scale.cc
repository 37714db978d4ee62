// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/first_pair_scale.h"

namespace framewise {

Step FirstPairScale::apply(Step step) {
  if (!is_measured(step.status) || step.status == Status::kRotationOnly) return step;
  if (!length_ && step.status == Status::kOk) length_ = step.length_from_depth;
  if (!length_) {
    step.status = Status::kNoDepth;
    step.covariance.setConstant(std::numeric_limits<double>::quiet_NaN());
    return step;
  }
  step.cam2_from_cam1.t *= *length_;
  step.covariance.rightCols<3>() *= *length_;
  step.covariance.bottomRows<3>() *= *length_;
  return step;
}

}  // namespace framewise
