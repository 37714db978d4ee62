// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// Homography of points on a plane, x2 ~ H x1: linear least squares on bearings, scaled so that its middle
// singular value is 1 and x2' H x1 > 0. Empty with fewer than 4 points or where they leave H free.
std::optional<Eigen::Matrix3d> plane_homography(std::span<const Bearing> x1, std::span<const Bearing> x2);

// The same on the points that most agree with it: fits, drops what lies beyond three times the median
// residual, and fits again. Follows the plane that most points are on.
std::optional<Eigen::Matrix3d> robust_plane_homography(std::span<const Bearing> x1,
                                                       std::span<const Bearing> x2);

// The two motions (t up to sign, |t| = 1) that H = R + t n' / d stands for. A plane seen twice cannot tell
// them apart; both give essential matrices that all its points satisfy. Empty where H is a rotation.
//   Ma, Soatto, Kosecka, Sastry, An Invitation to 3-D Vision, 2004, section 5.3.3.
Hypotheses<Pose, 2> motions_of_plane(const Eigen::Matrix3d& H);

}  // namespace framewise
