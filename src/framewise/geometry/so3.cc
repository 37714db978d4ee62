// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/so3.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

namespace framewise {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d S;
  S << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return S;
}

Eigen::Matrix3d so3_exp(const Eigen::Vector3d& phi) {
  const double theta2 = phi.squaredNorm();
  // Below 1e-8 rad the next term of either series is under 1e-17.
  const double theta = std::sqrt(theta2);
  const double half_sinc = theta < 1e-8 ? 0.5 : std::sin(0.5 * theta) / theta;
  const Eigen::Quaterniond q(std::cos(0.5 * theta), half_sinc * phi.x(), half_sinc * phi.y(),
                             half_sinc * phi.z());
  return q.toRotationMatrix();
}

Eigen::Vector3d so3_log(const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sin_half = q.vec().norm();
  const double w = q.w();
  if (sin_half < 1e-9) return 2.0 * q.vec() / w;
  return (2.0 * std::atan2(sin_half, w) / sin_half) * q.vec();
}

Eigen::Matrix3d so3_right_jacobian(const Eigen::Vector3d& phi) {
  const double theta2 = phi.squaredNorm();
  const Eigen::Matrix3d S = skew(phi);
  double a, b;  // Jr = I - a S + b S^2
  if (theta2 < 1e-6) {
    a = 0.5 - theta2 / 24.0;
    b = 1.0 / 6.0 - theta2 / 120.0;
  } else {
    const double theta = std::sqrt(theta2);
    a = (1.0 - std::cos(theta)) / theta2;
    b = (theta - std::sin(theta)) / (theta2 * theta);
  }
  return Eigen::Matrix3d::Identity() - a * S + b * S * S;
}

double rotation_angle(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d twice_sin_axis(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  return std::atan2(twice_sin_axis.norm(), R.trace() - 1.0);
}

Eigen::Vector3d euler_zyx(const Eigen::Matrix3d& R) {
  return {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0))),
          std::atan2(R(1, 0), R(0, 0))};
}

Eigen::Matrix3d rotation_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  // Two reflections: along a, and along h, half way from a to b. They take a to -a, and -a to b.
  const Eigen::Vector3d in_plane = b - b.dot(a) * a;
  Eigen::Vector3d across = in_plane.norm() > 1e-15 ? in_plane.normalized() : a.unitOrthogonal();
  across = (across - across.dot(a) * a).normalized();
  const Eigen::Vector3d h = 0.5 * ((a + b).norm() * a + (a - b).norm() * across);
  return Eigen::Matrix3d::Identity() - 2 * a * a.transpose() - 2 * h * (h - 2 * h.dot(a) * a).transpose();
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d d(1, 1, svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1);
  return svd.matrixU() * d.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace framewise
