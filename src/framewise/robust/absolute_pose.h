// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

struct AbsolutePoseOptions {
  RansacOptions ransac;
  double max_error = 2.0 / 525;  // reprojection error of an inlier: pixels / focal length, or rad
  int min_inliers = 6;           // fewer are no answer
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// Pose of camera 2 from points known in camera 1 (or the world) and the bearings that see them, some of them
// wrong: lambda x2 = R X1 + t. P3P in RANSAC, judged by reprojection, then least squares on what agrees, with
// the covariance of that. Bearings of any length.
// Empty: fewer than 4 points, or too few inliers. Throws std::invalid_argument on sizes that differ, on
// numbers that are not finite and on bearings of length zero.
std::optional<Estimate> estimate_absolute_pose(std::span<const Eigen::Vector3d> X1,
                                               std::span<const Bearing> x2,
                                               const AbsolutePoseOptions& options = {});

}  // namespace framewise
