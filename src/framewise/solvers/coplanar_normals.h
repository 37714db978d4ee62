// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// A rotation cam2_from_cam1 with the direction t that its epipolar normals n_i = x2_i x R x1_i are orthogonal
// to.
struct RotationAndDirection {
  Eigen::Matrix3d R;
  Eigen::Vector3d t;
  double cost = 0;  // sum (t . n_i)^2
};

// t for a rotation near a solution: the normal of the plane the epipolar normals almost lie in.
Eigen::Vector3d common_normal(std::span<const Bearing> x1, std::span<const Bearing> x2,
                              const Eigen::Matrix3d& R);

// Gauss-Newton on t . n_i = 0 over rotation and direction (5 unknowns; with five bearings Newton's method),
// more of them weighted (empty: all 1). `reach` (rad) bounds a step of the rotation: about the distance
// between neighbouring solutions. Empty when it does not settle.
std::optional<RotationAndDirection> polish_coplanar_normals(std::span<const Bearing> x1,
                                                            std::span<const Bearing> x2,
                                                            const RotationAndDirection& start, double reach,
                                                            std::span<const double> weights = {});

}  // namespace framewise
