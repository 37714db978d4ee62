// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// Rotation between two cameras at the same place, least squares: argmin sum w_i |x2_i - R x1_i|^2,
// R = cam2_from_cam1. Weights may be empty (all 1).
//   Wahba's problem by the singular value decomposition of sum w x2 x1': Markley, Attitude determination
//   using vector observations and the singular value decomposition, J. Astronautical Sciences 1988.
// Empty with fewer than 2 points and where the bearings leave the rotation free (all parallel, NaN).
// Throws std::invalid_argument when the sizes differ.
std::optional<Eigen::Matrix3d> rotation_npt(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                            std::span<const double> weights = {});

}  // namespace framewise
