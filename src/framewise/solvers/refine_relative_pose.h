// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/point_columns.h"
#include "framewise/solvers/refinement.h"

namespace framewise {

enum class EpipolarResidual {
  kSampson,      // first-order distance to the epipolar constraint
  kReprojection  // exact distance: two-view bundle adjustment, each point at its best place
};

struct RelativePoseRefinement : Refinement {
  // What the points say about the direction of t along the way they know least: smallest eigenvalue (1/rad^2)
  // of its information once the rotation is free, under the noise given. Its inverse root is the standard
  // deviation of the direction (rad). Noise alone makes it more than 0: compare with noise_information().
  double direction_information = 0;
};

// Rotation and direction of translation (|t| = 1) from rays seen in both cameras:
//   argmin sum rho(d(x1_i, x2_i; R, t)^2 / sigma^2), x2' [t]x R x1 = 0.
// 5 degrees of freedom; covariance has rank 5, with nothing along t. Rays of any length, at least 5; the
// initial t must not be 0. std::invalid_argument otherwise.
RelativePoseRefinement refine_relative_pose(const Pose& initial, std::span<const Eigen::Vector3d> x1,
                                            std::span<const Eigen::Vector3d> x2,
                                            const RefineOptions& options = {},
                                            EpipolarResidual residual = EpipolarResidual::kSampson);

// The same on columns filled by fill_ray_pairs (refine_input.h): allocates nothing.
RelativePoseRefinement refine_relative_pose(const Pose& initial, const PointColumns& ray_pairs,
                                            const RefineOptions& options = {},
                                            EpipolarResidual residual = EpipolarResidual::kSampson);

// Information about the direction of t that mere image noise would feign (1/rad^2), along the way the points
// know least: what direction_information tends to, or stays below, where there is no parallax at all. Where
// direction_information is less than twice this, neither direction nor covariance can be trusted; from four
// times on the covariance is honest for points in depth. Points on a plane, which fit a second motion nearly
// as well, need some sixty times.
double noise_information(const Pose& pose, const PointColumns& ray_pairs, const RefineOptions& options = {});

}  // namespace framewise
