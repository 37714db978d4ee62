// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/translation_2pt.h"

#include <Eigen/Geometry>
#include <cmath>

namespace framewise {

std::optional<Eigen::Vector3d> translation_2pt(const std::array<Bearing, 2>& x1,
                                               const std::array<Bearing, 2>& x2, const Eigen::Matrix3d& R) {
  const Eigen::Vector3d f0 = R * x1[0], f1 = R * x1[1];
  const Eigen::Vector3d n0 = f0.cross(x2[0]), n1 = f1.cross(x2[1]);
  const Eigen::Vector3d t = n0.cross(n1);
  // A normal carries a rounding error of about 1e-16, whatever its length.
  const double norm2 = t.squaredNorm();
  if (!(norm2 > 1e-28 * (n0.squaredNorm() + n1.squaredNorm()))) return std::nullopt;
  // t.(x2 - R x1) = (lambda1 + lambda2) (1 - cos(parallax)): every point in front says plus.
  const double vote = t.dot(x2[0] - f0 + (x2[1] - f1));
  return t * std::copysign(1 / std::sqrt(norm2), vote);
}

}  // namespace framewise
