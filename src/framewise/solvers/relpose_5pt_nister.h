// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// Relative pose of two calibrated cameras from five bearing pairs (unit vectors):
//   lambda2 x2 = R (lambda1 x1) + t,  |t| = 1;  E = [t]x R,  x2' E x1 = 0
//   Nister, An Efficient Solution to the Five-Point Relative Pose Problem, PAMI 2004: one unknown is hidden,
//   the determinant of a 3 x 3 matrix of polynomials, Eq. (18) to (28), gives it as a root of degree ten.
// Each solution is polished by Newton's method on the five equations, so it is exact as far as the points
// determine it. Without translation every t solves the equations: the rotation is right, the translation is
// any. No solution, or bearings that are not finite: empty.

// All essential matrices, singular values (1, 1, 0).
Hypotheses<Eigen::Matrix3d, 10> essential_5pt_nister(const std::array<Bearing, 5>& x1,
                                                     const std::array<Bearing, 5>& x2);

// Those motions that see all five points in front of both cameras.
Hypotheses<Pose, 10> relpose_5pt_nister(const std::array<Bearing, 5>& x1, const std::array<Bearing, 5>& x2);

}  // namespace framewise
