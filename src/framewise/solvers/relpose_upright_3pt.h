// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// Relative pose of two cameras whose y axes both point along gravity, from three bearings:
//   lambda2 * x2 = R * (lambda1 * x1) + t,  R a turn about the y axis,  |t| = 1.
// The three epipolar normals R x1 x x2 are coplanar: in q = tan(angle / 2) a quartic. Follows Sweeney, Flynn,
// Turk, Solving for relative pose with a partially known rotation is a quadratic eigenvalue problem, 3DV
// 2014, and departs from it: normals are seen from the frame half way between the cameras, where two of their
// coordinates are linear in q, so that the determinant has degree 4 as it stands. The sign of t is the one
// with the points in front. Half a turn exactly (q infinite) is not found. Empty when there is no solution or
// the data leave a curve of them.
Hypotheses<Pose, 4> relpose_upright_3pt(const std::array<Bearing, 3>& x1, const std::array<Bearing, 3>& x2);

// The same with the unit directions of gravity in either camera's own frame.
Hypotheses<Pose, 4> relpose_upright_3pt(const std::array<Bearing, 3>& x1, const std::array<Bearing, 3>& x2,
                                        const Bearing& gravity1, const Bearing& gravity2);

}  // namespace framewise
