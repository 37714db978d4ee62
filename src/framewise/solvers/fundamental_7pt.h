// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// Fundamental matrices of seven pairs of homogeneous points (bearings, or image points of size near 1):
//   x2' F x1 = 0, det F = 0, |F| = 1 (Frobenius)
//   Hartley and Zisserman, Multiple View Geometry, 2nd ed., section 11.1.2.
// One or three; seven points of a plane leave F undetermined, and the answer is a part of many.
// Points that are not finite: empty.
Hypotheses<Eigen::Matrix3d, 3> fundamental_7pt(const std::array<Eigen::Vector3d, 7>& x1,
                                               const std::array<Eigen::Vector3d, 7>& x2);

// The same for calibrated bearings: of each matrix the nearest essential one and its motion that has the most
// points in front of both cameras; |t| = 1. For exact bearings one of them is the true motion, the others
// solve x2' F x1 = 0 with an F that no calibrated pair has, and are near nothing.
Hypotheses<Pose, 3> relpose_7pt(const std::array<Bearing, 7>& x1, const std::array<Bearing, 7>& x2);

}  // namespace framewise
