// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

struct RotationEigensolution {
  Eigen::Matrix3d R;  // cam2_from_cam1
  Eigen::Vector3d t;  // direction of the translation, |t| = 1
  Eigen::Vector3d
      eigenvalues;  // of M(R), ascending; a middle one near the first says that t is not to be had
};

// Rotation and translation direction between two cameras from N >= 5 bearings (unique from about 6):
//   argmin over R of the smallest eigenvalue of M(R) = sum w_i n_i n_i',  n_i = x2_i x R x1_i,
// t its eigenvector; sign, and choice between R and (2 t t' - I) R, which fit alike, by a vote for points in
// front of both cameras. Kneip and Lynen, Direct optimization of frame-to-frame rotation, ICCV 2013. Newton's
// method with analytic derivatives and bounded steps runs from a fixed list of starts (guess, rotation-only,
// linear solution, turns about the rotation-only one) until the minimum is as low as the linear solution's
// residual lets expect, else to the end of the list; the lowest wins.
// Weights may be empty (all 1).
// Empty with fewer than 5 points or where the bearings leave the rotation free (all parallel, NaN).
// Throws std::invalid_argument when the sizes differ.
std::optional<RotationEigensolution> rotation_eigensolver(std::span<const Bearing> x1,
                                                          std::span<const Bearing> x2,
                                                          std::optional<Eigen::Matrix3d> guess = {},
                                                          std::span<const double> weights = {});

}  // namespace framewise
