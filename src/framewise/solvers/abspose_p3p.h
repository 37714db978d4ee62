// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// Pose of a calibrated camera, cam_from_world, from three bearings x and the three points X they see (m):
//   lambda_i x_i = R X_i + t,  lambda_i > 0.
// The depth ratios lambda1 / lambda3, lambda2 / lambda3 are where two conics meet; a degenerate conic of
// their pencil gives two lines that hold the up to four points. Follows Ding, Yang, Larsson, Olsson, Åström,
// Revisiting the P3P problem, CVPR 2023 (section 3); depths are then polished as in Persson and Nordberg,
// Lambda Twist, ECCV 2018 (section 3.7).
// Empty when no pose has the points in front of the camera, or the points are collinear.
Hypotheses<Pose, 4> abspose_p3p(const std::array<Bearing, 3>& x, const std::array<Eigen::Vector3d, 3>& X);

}  // namespace framewise
