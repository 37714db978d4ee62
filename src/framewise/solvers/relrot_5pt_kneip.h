// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "framewise/geometry/pose.h"
#include "framewise/solvers/hypotheses.h"

namespace framewise {

// All rotations R = cam2_from_cam1 for which the normals of the five epipolar planes, n_i = x2_i x R x1_i,
// lie in one plane (the translation is its normal): up to 20, in pairs R, (2 t t' - I) R that share the
// translation direction t, a pair side by side. No essential matrix on the way.
//   Kneip, Siegwart, Pollefeys, Finding the exact rotation between two images independently of the
//   translation, ECCV 2012: the constraint is their Eq. (6), |n_i n_j n_k| = 0 for all triples.
// Where it departs: with quaternions, x2_i q x1_i = (n_i - x2_i . R x1_i) q is linear in q, A_i q with a
// constant symmetric 4 x 4 matrix A_i, and the normals are coplanar exactly when the 4 x 6 matrix [q, A_1 q,
// ..., A_5 q] has rank 3 at most. Its 15 minors of size 4 are quartics whose degree-4 parts express all 15
// monomials of degree 4 by the 20 of lower degree, so one 15 x 35 elimination gives the action matrix (the
// paper: a Groebner basis of 66 equations). The rotation nearest to pure rotation is taken out first and the
// unknowns scaled by the parallax it leaves, which spreads the solutions a small motion crowds together;
// Newton's method on t . n_i = 0 polishes. Empty when the data leave a curve of rotations (pure rotation,
// fewer than five distinct points).
Hypotheses<Eigen::Matrix3d, 20> relrot_5pt_kneip(const std::array<Bearing, 5>& x1,
                                                 const std::array<Bearing, 5>& x2);

// The same from 5 to 8 bearings. The first five give the rotations; with more, each is refined to the nearest
// minimum of sum (t . n_i)^2 over all bearings, and the best stand first. Throws std::invalid_argument when
// the sizes differ or are not 5 to 8.
Hypotheses<Eigen::Matrix3d, 20> relrot_5pt_kneip(std::span<const Bearing> x1, std::span<const Bearing> x2);

}  // namespace framewise
