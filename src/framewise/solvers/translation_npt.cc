// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/translation_npt.h"

#include <Eigen/Geometry>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/solvers/matching_sizes.h"

namespace framewise {

std::optional<Eigen::Vector3d> translation_npt(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                               const Eigen::Matrix3d& R, std::span<const double> weights) {
  check_matching_sizes("translation_npt", x1.size(), x2.size(), weights.size());
  if (x1.size() < 2) return std::nullopt;

  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // sum w n n'
  Eigen::Vector3d parallax = Eigen::Vector3d::Zero();     // sum w (x2 - R x1)
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const double w = weights.empty() ? 1.0 : weights[i];
    const Eigen::Vector3d f = R * x1[i];
    const Eigen::Vector3d n = f.cross(x2[i]), wn = w * n;
    xx += wn.x() * n.x(), xy += wn.x() * n.y(), xz += wn.x() * n.z();
    yy += wn.y() * n.y(), yz += wn.y() * n.z(), zz += wn.z() * n.z();
    parallax += w * (x2[i] - f);
  }
  Eigen::Matrix3d M;
  M << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  if (!M.allFinite()) return std::nullopt;

  const SymmetricEigen<3> eigen = symmetric_eigen(M);
  // The middle eigenvalue must stand out of the rounding errors of M (relative) and of the normals (1e-16
  // each).
  const double middle = eigen.values[1], largest = eigen.values[2];
  if (!(middle > 1e-14 * largest && middle > 1e-30 * static_cast<double>(x1.size()))) return std::nullopt;
  Eigen::Vector3d t = eigen.vectors.col(0);
  // t.(x2 - R x1) = (lambda1 + lambda2) (1 - cos(parallax)): every point in front says plus.
  if (t.dot(parallax) < 0) t = -t;
  return t;
}

}  // namespace framewise
