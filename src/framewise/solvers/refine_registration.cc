// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_registration.h"

#include <stdexcept>
#include <string>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/solvers/levenberg_marquardt.h"
#include "framewise/solvers/refine_input.h"

namespace framewise {
namespace {

void set_cloud_row(PointColumns& columns, std::size_t row, std::size_t first, const Eigen::Vector3d& X,
                   const Eigen::Matrix3d& S) {
  columns.set3(row, first, X.x(), X.y(), X.z());
  columns.set3(row, first + 3, S(0, 0), S(0, 1), S(0, 2));
  columns.set3(row, first + 6, S(1, 1), S(1, 2), S(2, 2));
}

// A sum of two proper covariances is positive definite where one of them is.
void check_covariances(const Eigen::Matrix3d& S1, const Eigen::Matrix3d& S2, std::size_t i) {
  const Eigen::Matrix3d S = S1 + S2;
  const bool symmetric =
      (S1 - S1.transpose()).norm() <= 1e-9 * S1.norm() && (S2 - S2.transpose()).norm() <= 1e-9 * S2.norm();
  const bool proper = S1.diagonal().minCoeff() >= 0 && S2.diagonal().minCoeff() >= 0 && S.allFinite() &&
                      Cholesky<3>(S).positive_definite();
  if (!symmetric || !proper)
    throw std::invalid_argument("S1 + S2 of point " + std::to_string(i) +
                                " is no covariance, expected symmetric and positive definite");
}

}  // namespace

void fill_registration(PointColumns& columns, std::span<const Eigen::Vector3d> X1,
                       std::span<const Eigen::Matrix3d> S1, std::span<const Eigen::Vector3d> X2,
                       std::span<const Eigen::Matrix3d> S2) {
  check_sizes("X2", X2.size(), "X1", X1.size());
  check_sizes("S1", S1.size(), "X1", X1.size());
  check_sizes("S2", S2.size(), "X1", X1.size());
  check_finite("X1", X1);
  check_finite("X2", X2);
  columns.reset(X1.size(), 19);
  for (std::size_t i = 0; i < X1.size(); ++i) {
    check_covariances(S1[i], S2[i], i);
    set_cloud_row(columns, i, 1, X1[i], S1[i]);
    set_cloud_row(columns, i, 10, X2[i], S2[i]);
  }
}

Refinement refine_registration(const Pose& initial, const PointColumns& clouds,
                               const RefineOptions& options) {
  options.check();
  check_pose(initial);
  check_at_least("X1", clouds.rows(), 3);
  return minimise<RigidMotion>(
      initial, [&](const Pose& pose) { return sum_registration(clouds, kernel_pose(pose), options.loss); },
      options);
}

Refinement refine_registration(const Pose& initial, std::span<const Eigen::Vector3d> X1,
                               std::span<const Eigen::Matrix3d> S1, std::span<const Eigen::Vector3d> X2,
                               std::span<const Eigen::Matrix3d> S2, const RefineOptions& options) {
  PointColumns clouds;
  fill_registration(clouds, X1, S1, X2, S2);
  return refine_registration(initial, clouds, options);
}

}  // namespace framewise
