// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_2pt.h"

#include <Eigen/Geometry>
#include <cmath>

namespace framewise {
namespace {

// Columns: the unit vectors along a + b, a - b and their cross product. False when a and b are parallel.
bool bisector_frame(const Bearing& a, const Bearing& b, Eigen::Matrix3d& frame) {
  const Eigen::Vector3d sum = a + b, difference = a - b;
  const double sum2 = sum.squaredNorm(), difference2 = difference.squaredNorm();
  if (!(sum2 > 1e-24 && difference2 > 1e-24)) return false;
  frame.col(0) = sum / std::sqrt(sum2);
  // Unit bearings make the two orthogonal up to rounding, which a small sum or difference enlarges.
  const Eigen::Vector3d orthogonal = difference - frame.col(0).dot(difference) * frame.col(0);
  frame.col(1) = orthogonal.normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return true;
}

}  // namespace

std::optional<Eigen::Matrix3d> rotation_2pt(const std::array<Bearing, 2>& x1,
                                            const std::array<Bearing, 2>& x2) {
  Eigen::Matrix3d frame1, frame2;
  if (!bisector_frame(x1[0], x1[1], frame1) || !bisector_frame(x2[0], x2[1], frame2)) return std::nullopt;
  return frame2 * frame1.transpose();
}

}  // namespace framewise
