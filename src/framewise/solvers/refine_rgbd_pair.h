// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "framewise/geometry/depth_noise.h"
#include "framewise/solvers/point_columns.h"
#include "framewise/solvers/refinement.h"

namespace framewise {

// Rigid motion (metres) between two pinhole cameras with depth, from all that both saw: each correspondence
// counts for what it holds. Depth in both views: the two points, with the covariances of image and depth
// noise. Depth in one view: that point against the other's ray. Depth in none: the two rays, which know the
// rotation and the direction of t. Each term is exact to first order in the noise of all its measurements:
//   argmin sum rho(e_i' Sigma_i^-1 e_i).
// x1, x2 are rays with z > 0, z1, z2 depths along the optical axis; NaN (or 0 or less) says there is none.
// options.sigma is the image noise; the surface is the plane. At least 3 correspondences.
// std::invalid_argument for wrong input; where depths do not suffice for the scale, covariance is NaN.
Refinement refine_rgbd_pair(const Pose& initial, std::span<const Eigen::Vector3d> x1,
                            std::span<const double> z1, std::span<const Eigen::Vector3d> x2,
                            std::span<const double> z2, const DepthNoise& noise = {},
                            const RefineOptions& options = {});

// The correspondences sorted by what they hold; with a subset only those it lists. Memory is kept from one
// fill to the next, so refining on it allocates nothing.
struct RgbdColumns {
  PointColumns both;    // as fill_registration
  PointColumns first;   // X1, S1, x2
  PointColumns second;  // X2, S2, x1
  PointColumns none;    // as fill_ray_pairs
};
void fill_rgbd_pair(RgbdColumns& columns, std::span<const Eigen::Vector3d> x1, std::span<const double> z1,
                    std::span<const Eigen::Vector3d> x2, std::span<const double> z2, const DepthNoise& noise,
                    double image_sigma, std::span<const std::uint32_t> subset = {});
Refinement refine_rgbd_pair(const Pose& initial, const RgbdColumns& columns,
                            const RefineOptions& options = {});

}  // namespace framewise
