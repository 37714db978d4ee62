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

// Length (m) of a step whose rotation R and unit direction t are known, from points with depth in both
// frames:
//   X2_i = R X1_i + length * t   =>   length_i = t . (X2_i - R X1_i),
// the median over the inliers, so that a wrong depth does not count. X1, X2: NaN where depth is unknown;
// inliers: 1 for each correspondence to be used. Empty where fewer than 5 points have both depths.
std::optional<double> length_from_depth(const Pose& cam2_from_cam1, std::span<const Eigen::Vector3d> X1,
                                        std::span<const Eigen::Vector3d> X2,
                                        std::span<const std::uint8_t> inliers);

}  // namespace framewise
