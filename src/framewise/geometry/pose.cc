// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/pose.h"

#include "framewise/geometry/so3.h"

namespace framewise {

Pose interpolate(const Pose& a, const Pose& b, double s) {
  return {a.R * so3_exp(s * so3_log(a.R.transpose() * b.R)), (1.0 - s) * a.t + s * b.t};
}

// R' = R^T turns by -R w where R turns by w, and t' = -R^T t moves by -R^T dt - [R^T t]x w.
Matrix6d inverse_covariance(const Pose& pose, const Matrix6d& covariance) {
  const Eigen::Matrix3d back = pose.R.transpose();
  Matrix6d J = Matrix6d::Zero();
  J.topLeftCorner<3, 3>() = -pose.R;
  J.bottomLeftCorner<3, 3>() = -skew(back * pose.t);
  J.bottomRightCorner<3, 3>() = -back;
  Matrix6d inverse = J * covariance * J.transpose();
  // Of the rotation alone, which may be known where the translation is not.
  inverse.topLeftCorner<3, 3>() = pose.R * covariance.topLeftCorner<3, 3>() * back;
  return inverse;
}

}  // namespace framewise
