// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/first_pair_scale.h"

namespace framewise {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Step turned_only(Step step) {
  step.status = Status::kRotationOnly;
  step.cam2_from_cam1.t.setZero();
  step.covariance.rightCols<3>().setConstant(kUnknown);
  step.covariance.bottomRows<3>().setConstant(kUnknown);
  return step;
}

Step without_length(Step step) {
  step.status = Status::kNoDepth;
  step.covariance.setConstant(kUnknown);
  return step;
}

}  // namespace

Step FirstPairScale::apply(Step step) {
  if (!is_measured(step.status) || step.status == Status::kRotationOnly) return step;
  if (!length_ && step.status == Status::kOk) length_ = step.length_from_depth;
  if (!length_) return step.status == Status::kLowParallax ? turned_only(step) : without_length(step);
  step.cam2_from_cam1.t *= *length_;
  step.covariance.rightCols<3>() *= *length_;
  step.covariance.bottomRows<3>() *= *length_;
  return step;
}

}  // namespace framewise
