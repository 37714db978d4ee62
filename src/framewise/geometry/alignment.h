// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// Rigid motion that takes points onto points, least squares: argmin sum w_i |x2_i - (R x1_i + t)|^2.
// Weights may be empty (all 1). Empty when the points leave the rotation free (fewer than 3, collinear, NaN).
// Throws std::invalid_argument where sizes differ or a weight is negative or NaN.
//   Arun, Huang, Blostein, Least-squares fitting of two 3-D point sets, PAMI 1987; sign by Umeyama, PAMI
//   1991.
std::optional<Pose> kabsch(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                           std::span<const double> weights = {});

// x2 = scale * R * x1 + t
struct Similarity {
  double scale = 1;
  Pose pose;
};

// The same with a scale: argmin sum |x2_i - (scale R x1_i + t)|^2. Umeyama, PAMI 1991, Eq. (40)-(42).
std::optional<Similarity> umeyama(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2);

}  // namespace framewise
