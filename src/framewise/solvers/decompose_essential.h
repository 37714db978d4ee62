// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/pose.h"

namespace framewise {

// Essential matrices and the motions they stand for: E = [t]x R, x2' E x1 = 0, x_in_cam2 = R x_in_cam1 + t.

// The matrix with singular values (1, 1, 0) that is nearest to M up to M's scale (Frobenius norm).
Eigen::Matrix3d nearest_essential(const Eigen::Matrix3d& M);

// The four motions of E: (Ra, t), (Ra, -t), (Rb, t), (Rb, -t), |t| = 1, R a rotation to rounding for any
// finite E.
//   Hartley and Zisserman, Multiple View Geometry, 2nd ed., result 9.19.
std::array<Pose, 4> decompose_essential(const Eigen::Matrix3d& E);

// A motion and how many of the given bearings meet in front of both cameras under it.
struct CheiralityVote {
  Pose cam2_from_cam1;
  std::size_t in_front = 0;
};

// Of the four motions of E the one with the most points in front of both cameras (ties: the first of
// decompose_essential's order). Empty when no point is, or E or the bearings are not finite.
// Throws std::invalid_argument when x1 and x2 differ in size.
std::optional<CheiralityVote> choose_by_cheirality(const Eigen::Matrix3d& E, std::span<const Bearing> x1,
                                                   std::span<const Bearing> x2);

// True when the rays lambda1 x1 and lambda2 x2 are closest at lambda1, lambda2 > 0.
inline bool in_front_of_both(const Pose& cam2_from_cam1, const Bearing& x1, const Bearing& x2) {
  // lambda2 x2 = lambda1 R x1 + t, crossed with x2 and with R x1. The products with n keep the sign down to
  // tiny parallax, where the normal equations cancel.
  const Eigen::Vector3d Rx1 = cam2_from_cam1.R * x1;
  const Eigen::Vector3d n = Rx1.cross(x2);
  return x2.cross(cam2_from_cam1.t).dot(n) > 0 && Rx1.cross(cam2_from_cam1.t).dot(n) > 0;
}

}  // namespace framewise
