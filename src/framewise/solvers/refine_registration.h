// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "framewise/solvers/point_columns.h"
#include "framewise/solvers/refinement.h"

namespace framewise {

// Rigid motion between two clouds where each point has its own covariance, S1 in camera 1 and S2 in camera 2:
//   argmin sum rho(e_i' (R S1_i R' + S2_i)^-1 e_i), e_i = R X1_i + t - X2_i,
// the maximum likelihood once every true point is at its best place; R's part in the weight is in the
// derivative. At least 3 points; covariances symmetric, S1 + S2 positive definite (m^2).
// std::invalid_argument otherwise. Of the options, sigma and surface are not used.
Refinement refine_registration(const Pose& initial, std::span<const Eigen::Vector3d> X1,
                               std::span<const Eigen::Matrix3d> S1, std::span<const Eigen::Vector3d> X2,
                               std::span<const Eigen::Matrix3d> S2, const RefineOptions& options = {});

// Columns X1 (3), S1 (6), X2 (3), S2 (6), and the same on them: allocates nothing.
void fill_registration(PointColumns& columns, std::span<const Eigen::Vector3d> X1,
                       std::span<const Eigen::Matrix3d> S1, std::span<const Eigen::Vector3d> X2,
                       std::span<const Eigen::Matrix3d> S2);
Refinement refine_registration(const Pose& initial, const PointColumns& clouds,
                               const RefineOptions& options = {});

}  // namespace framewise
