// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// Essential matrix of N >= 8 bearing pairs, linear least squares:
//   argmin sum w_i (x2_i' E x1_i)^2, then the nearest matrix with singular values (1, 1, 0).
//   Longuet-Higgins, A computer algorithm for reconstructing a scene from two projections, Nature 1981;
//   Hartley, In defense of the eight-point algorithm, PAMI 1997. Hartley's normalisation is done here for any
//   field of view: both sets of bearings are transformed to second moments N/3 I before E is scaled to
//   norm 1.
// Weights (>= 0) may be empty (all 1). The linear problem does not know that E has 5 degrees of freedom:
// points on a plane, or motion without translation, leave it undetermined, and the answer is one of many.
// Empty when bearings or weights are not finite. Throws std::invalid_argument when sizes differ or N < 8.
std::optional<Eigen::Matrix3d> essential_8pt(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                             std::span<const double> weights = {});

}  // namespace framewise
