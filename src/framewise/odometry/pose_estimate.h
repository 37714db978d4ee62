// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/geometry/pose.h"

namespace framewise {

// A motion and how far it may be off: covariance of the tangent vector (rotation, translation), R
// exp(rotation) and t + translation, in rad and the unit of t.
struct PoseEstimate {
  Pose cam2_from_cam1;
  Matrix6d covariance = Matrix6d::Zero();
};

// cam3_from_cam1 by way of camera 2; the errors of the two are independent. To first order.
PoseEstimate chained(const PoseEstimate& cam3_from_cam2, const PoseEstimate& cam2_from_cam1);

// The motion between two cameras that were each placed from a third, with errors of their own. To first
// order.
PoseEstimate between(const PoseEstimate& cam2_from_base, const PoseEstimate& cam1_from_base);

// Two independent estimates of one motion, weighed by their covariances (Gauss-Markov, one step of a Kalman
// filter). Empty where they contradict each other: where their difference is one that chance makes in a
// thousandth of all cases or less, or where a covariance is not known.
std::optional<PoseEstimate> fused(const PoseEstimate& a, const PoseEstimate& b);

}  // namespace framewise
