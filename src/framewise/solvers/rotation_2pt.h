// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "framewise/geometry/pose.h"

namespace framewise {

// Rotation between two cameras at the same place from two bearings: x2 = R x1, R = cam2_from_cam1.
// Where the angles between the bearings differ, the answer is the least-squares one for equal weights: it
// takes the bisector frame (a + b, a - b, their cross product) of x1 onto that of x2 (Markley, Attitude
// determination using two vector measurements, 1999). Empty when the two bearings of a camera are parallel.
std::optional<Eigen::Matrix3d> rotation_2pt(const std::array<Bearing, 2>& x1,
                                            const std::array<Bearing, 2>& x2);

}  // namespace framewise
