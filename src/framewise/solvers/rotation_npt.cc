// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_npt.h"

#include <Eigen/Geometry>

#include "framewise/geometry/so3.h"
#include "framewise/solvers/matching_sizes.h"

namespace framewise {
namespace {

// Rank 2 at least: one of the 2x2 minors is not rounding. (Frobenius norm of the cofactors.)
bool fixes_a_rotation(const Eigen::Matrix3d& K) {
  const double cofactors2 = K.col(0).cross(K.col(1)).squaredNorm() + K.col(1).cross(K.col(2)).squaredNorm() +
                            K.col(2).cross(K.col(0)).squaredNorm();
  const double norm2 = K.squaredNorm();
  return cofactors2 > 1e-26 * norm2 * norm2;
}

}  // namespace

std::optional<Eigen::Matrix3d> rotation_npt(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                            std::span<const double> weights) {
  check_matching_sizes("rotation_npt", x1.size(), x2.size(), weights.size());
  if (x1.size() < 2) return std::nullopt;
  Eigen::Matrix3d K = Eigen::Matrix3d::Zero();
  if (weights.empty())
    for (std::size_t i = 0; i < x1.size(); ++i) K.noalias() += x2[i] * x1[i].transpose();
  else
    for (std::size_t i = 0; i < x1.size(); ++i) K.noalias() += (weights[i] * x2[i]) * x1[i].transpose();
  if (!K.allFinite() || !fixes_a_rotation(K)) return std::nullopt;
  return nearest_rotation(K);
}

}  // namespace framewise
