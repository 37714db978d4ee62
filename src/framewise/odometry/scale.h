// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "framewise/geometry/pose.h"

namespace framewise {

// Where the length of a step comes from, whose rotation R and perhaps unit direction t two views gave. X1,
// X2: points of the correspondences in either camera (m), NaN where depth is unknown; inliers: 1 for each to
// be used. Both are empty where fewer than 5 points have both depths.

// Length (m) along the direction t, from
//   X2_i = R X1_i + length * t   =>   length_i = t . (X2_i - R X1_i),
// the median over the inliers, so that a wrong depth does not count.
std::optional<double> length_from_depth(const Pose& cam2_from_cam1, std::span<const Eigen::Vector3d> X1,
                                        std::span<const Eigen::Vector3d> X2,
                                        std::span<const std::uint8_t> inliers);

// Translation (m) from the centroids c1, c2 of the points under the rotation alone,
//   t = c2 - R c1,
// the least-squares answer for a rotation that is given. Every wrong depth counts.
std::optional<Eigen::Vector3d> translation_from_centroids(const Eigen::Matrix3d& R,
                                                          std::span<const Eigen::Vector3d> X1,
                                                          std::span<const Eigen::Vector3d> X2,
                                                          std::span<const std::uint8_t> inliers);

}  // namespace framewise
