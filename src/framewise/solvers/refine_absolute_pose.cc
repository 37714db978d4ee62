// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_absolute_pose.h"

#include "framewise/solvers/levenberg_marquardt.h"
#include "framewise/solvers/refine_input.h"

namespace framewise {

Refinement refine_absolute_pose(const Pose& initial, const PointColumns& points_and_rays,
                                const RefineOptions& options) {
  options.check();
  check_pose(initial);
  check_at_least("X1", points_and_rays.rows(), 3);
  const auto sums_at = [&](const Pose& pose) {
    const auto sum = options.surface == ImageSurface::kPlane ? sum_projection_plane : sum_projection_sphere;
    return sum(points_and_rays, kernel_pose(pose), options.sigma, options.loss);
  };
  return minimise<RigidMotion>(initial, sums_at, options);
}

Refinement refine_absolute_pose(const Pose& initial, std::span<const Eigen::Vector3d> X1,
                                std::span<const Eigen::Vector3d> x2, const RefineOptions& options) {
  options.check();
  PointColumns points_and_rays;
  fill_points_and_rays(points_and_rays, X1, x2, options.surface);
  return refine_absolute_pose(initial, points_and_rays, options);
}

}  // namespace framewise
