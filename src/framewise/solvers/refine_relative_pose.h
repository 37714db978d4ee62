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

// Rotation and direction of translation (|t| = 1) from rays seen in both cameras:
//   argmin sum rho(d(x1_i, x2_i; R, t)^2 / sigma^2), x2' [t]x R x1 = 0.
// 5 degrees of freedom; covariance has rank 5, with nothing along t. Rays of any length, at least 5; the
// initial t must not be 0. std::invalid_argument otherwise.
Refinement refine_relative_pose(const Pose& initial, std::span<const Eigen::Vector3d> x1,
                                std::span<const Eigen::Vector3d> x2, const RefineOptions& options = {},
                                EpipolarResidual residual = EpipolarResidual::kSampson);

// The same on columns filled by fill_ray_pairs (refine_input.h): allocates nothing.
Refinement refine_relative_pose(const Pose& initial, const PointColumns& ray_pairs,
                                const RefineOptions& options = {},
                                EpipolarResidual residual = EpipolarResidual::kSampson);

// What the points say about the direction of t along the way they know least (1/rad^2).
struct DirectionInformation {
  // Smallest eigenvalue of its information once the rotation is free, under the noise given. The inverse root
  // is the standard deviation of the direction (rad).
  double measured = 0;
  // What mere image noise would feign along the same way: what `measured` tends to, or stays below, where
  // there is no parallax at all.
  double feigned = 0;
};

// Where measured is less than twice feigned, neither direction nor covariance can be trusted; from four times
// on the covariance is honest for points in depth. Points on a plane, which fit a second motion nearly as
// well, need some sixty times. Rays near the direction of t feign most and know least.
DirectionInformation direction_information(const Pose& pose, const PointColumns& ray_pairs,
                                           const RefineOptions& options = {});

}  // namespace framewise
