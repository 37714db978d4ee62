// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "framewise/solvers/point_columns.h"
#include "framewise/solvers/refinement.h"

namespace framewise {

// Pose of a camera that sees the points X1, known without error, along the rays x2:
//   argmin sum rho(d(R X1_i + t, x2_i)^2 / sigma^2), d on the plane z = 1 or the chord on the sphere.
// Rays of any length; at least 3. std::invalid_argument otherwise.
Refinement refine_absolute_pose(const Pose& initial, std::span<const Eigen::Vector3d> X1,
                                std::span<const Eigen::Vector3d> x2, const RefineOptions& options = {});

// The same on columns filled by fill_points_and_rays (refine_input.h): allocates nothing.
Refinement refine_absolute_pose(const Pose& initial, const PointColumns& points_and_rays,
                                const RefineOptions& options = {});

}  // namespace framewise
