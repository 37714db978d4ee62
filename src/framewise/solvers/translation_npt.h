// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// Direction of the translation between two cameras whose rotation R = cam2_from_cam1 is known, least squares:
//   argmin over |t| = 1 of sum w_i (t . n_i)^2,  n_i = R x1_i x x2_i,
// the eigenvector of sum w_i n_i n_i' of the smallest eigenvalue (Kneip and Lynen, Direct optimization of
// frame-to-frame rotation, ICCV 2013, Eq. (3)-(6)). Its sign is a vote for points in front of both cameras,
// each point with the weight of its parallax. Weights may be empty (all 1). Empty with fewer than 2 points,
// and where the normals do not span a plane (no parallax, one epipolar plane). Throws std::invalid_argument
// when the sizes differ.
std::optional<Eigen::Vector3d> translation_npt(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                               const Eigen::Matrix3d& R,
                                               std::span<const double> weights = {});

}  // namespace framewise
