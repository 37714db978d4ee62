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

// From four points, x2 ~ H x1, of any scale. Empty where three of them are in line.
//   Hartley, Zisserman, Multiple View Geometry, 2004, section 4.1: the frame of three points and their sum.
std::optional<Eigen::Matrix3d> homography_4pt(std::span<const Bearing, 4> x1, std::span<const Bearing, 4> x2);

// The plane that most points are on, half of them or more: of homographies of four points each, drawn from a
// fixed stream, that with the least median residual (Rousseeuw, Least Median of Squares Regression, JASA
// 1984), then plane_homography of what lies within three times the median residual, twice. Empty as
// plane_homography.
std::optional<Eigen::Matrix3d> robust_plane_homography(std::span<const Bearing> x1,
                                                       std::span<const Bearing> x2);

// The two motions (t up to sign, |t| = 1) that H = R + t n' / d stands for. A plane seen twice cannot tell
// them apart; both give essential matrices that all its points satisfy. Empty where H is a rotation.
//   Ma, Soatto, Kosecka, Sastry, An Invitation to 3-D Vision, 2004, section 5.3.3.
Hypotheses<Pose, 2> motions_of_plane(const Eigen::Matrix3d& H);

}  // namespace framewise
