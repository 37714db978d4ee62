// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/pose_estimate.h"

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"

namespace framewise {

// R3 exp(w3) R2 exp(w2) = R3 R2 exp(R2' w3) exp(w2), and R3 exp(w3) (t2 + tau2) + t3 + tau3.
PoseEstimate chained(const PoseEstimate& cam3_from_cam2, const PoseEstimate& cam2_from_cam1) {
  const Pose& third = cam3_from_cam2.cam2_from_cam1;
  const Pose& second = cam2_from_cam1.cam2_from_cam1;
  Matrix6d by_third = Matrix6d::Identity(), by_second = Matrix6d::Identity();
  by_third.topLeftCorner<3, 3>() = second.R.transpose();
  by_third.bottomLeftCorner<3, 3>() = -third.R * skew(second.t);
  by_second.bottomRightCorner<3, 3>() = third.R;
  return {third * second, by_third * cam3_from_cam2.covariance * by_third.transpose() +
                              by_second * cam2_from_cam1.covariance * by_second.transpose()};
}

// The inverse of R exp(w), t + tau is exp(-w) R', -exp(-w) R' (t + tau).
PoseEstimate between(const PoseEstimate& cam2_from_base, const PoseEstimate& cam1_from_base) {
  const Pose& pose = cam1_from_base.cam2_from_cam1;
  const Pose inverse = pose.inverse();
  Matrix6d by_pose = Matrix6d::Zero();
  by_pose.topLeftCorner<3, 3>() = -pose.R;
  by_pose.bottomLeftCorner<3, 3>() = skew(inverse.t);
  by_pose.bottomRightCorner<3, 3>() = -inverse.R;
  return chained(cam2_from_base, {inverse, by_pose * cam1_from_base.covariance * by_pose.transpose()});
}

std::optional<PoseEstimate> fused(const PoseEstimate& a, const PoseEstimate& b) {
  constexpr double kContradiction = 22.46;  // chi square of six degrees of freedom, one in a thousand
  if (!a.covariance.allFinite() || !b.covariance.allFinite()) return std::nullopt;
  const Cholesky<6> sum(a.covariance + b.covariance);
  if (!sum.positive_definite()) return std::nullopt;
  Vector6d difference;
  difference << so3_log(a.cam2_from_cam1.R.transpose() * b.cam2_from_cam1.R),
      b.cam2_from_cam1.t - a.cam2_from_cam1.t;
  const Vector6d weighed = sum.solve(difference);
  if (!(difference.dot(weighed) <= kContradiction)) return std::nullopt;
  const Vector6d moved = a.covariance * weighed;
  const Matrix6d covariance = a.covariance - a.covariance * sum.inverse() * a.covariance;
  return PoseEstimate{{a.cam2_from_cam1.R * so3_exp(moved.head<3>()), a.cam2_from_cam1.t + moved.tail<3>()},
                      0.5 * (covariance + covariance.transpose())};
}

}  // namespace framewise
