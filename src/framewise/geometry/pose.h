// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace framewise {

// Unit vector from a camera's centre towards a point, in that camera's axes.
using Bearing = Eigen::Vector3d;

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

// A rigid motion b_from_a: x_in_b = R * x_in_a + t.
// Its tangent vectors are (rotation, translation), rad and metres, with R exp(rotation) and t + translation.
struct Pose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  static Pose from_quaternion(const Eigen::Quaterniond& q, const Eigen::Vector3d& t) {
    return {q.normalized().toRotationMatrix(), t};
  }

  Eigen::Quaterniond quaternion() const { return Eigen::Quaterniond(R); }

  Pose inverse() const { return {R.transpose(), -(R.transpose() * t)}; }

  // c_from_a = c_from_b * b_from_a
  Pose operator*(const Pose& b_from_a) const { return {R * b_from_a.R, R * b_from_a.t + t}; }

  Eigen::Vector3d operator*(const Eigen::Vector3d& x_in_a) const { return R * x_in_a + t; }

  Eigen::Matrix4d matrix() const {
    Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
    M.topLeftCorner<3, 3>() = R;
    M.topRightCorner<3, 1>() = t;
    return M;
  }
};

// A pose between two poses: rotation by slerp, translation linear; s = 0 gives a, s = 1 gives b.
Pose interpolate(const Pose& a, const Pose& b, double s);

// Covariance of the inverse's tangent vector, from that of the pose's.
Matrix6d inverse_covariance(const Pose& pose, const Matrix6d& covariance);

}  // namespace framewise
