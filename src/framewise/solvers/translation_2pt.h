// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "framewise/geometry/pose.h"

namespace framewise {

// Direction of the translation between two cameras whose rotation R = cam2_from_cam1 is known, from two
// bearings.
//   lambda2 * x2 = lambda1 * R x1 + t,  |t| = 1:  t is orthogonal to both epipolar normals R x1 x x2,
//   so t is their cross product (Kneip, Chli, Siegwart, Robust real-time visual odometry with a single camera
//   and an IMU, BMVC 2011, section 3). The sign is the one with the points in front of both cameras.
// Empty where the normals do not span a plane: no parallax, or both points in one epipolar plane.
std::optional<Eigen::Vector3d> translation_2pt(const std::array<Bearing, 2>& x1,
                                               const std::array<Bearing, 2>& x2, const Eigen::Matrix3d& R);

}  // namespace framewise
