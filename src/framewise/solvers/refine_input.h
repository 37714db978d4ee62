// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"
#include "framewise/solvers/point_columns.h"

// From points to the columns that refinement reads. All throw std::invalid_argument naming the argument.
namespace framewise {

using Points = std::span<const Eigen::Vector3d>;

// Rays of any length become points of the surface: x / x.z with x.z > 0, or x / |x|.
// Columns x1 (3), x2 (3). With a subset, only the correspondences it lists, in its order.
void fill_ray_pairs(PointColumns& columns, Points x1, Points x2, ImageSurface surface,
                    std::span<const std::uint32_t> subset = {});

// Columns X1 (3), x2 (3): points in camera 1, rays in camera 2.
void fill_points_and_rays(PointColumns& columns, Points X1, Points x2, ImageSurface surface,
                          std::span<const std::uint32_t> subset = {});

void check_pose(const Pose& initial);
void check_sizes(const char* name, std::size_t size, const char* name_of_first, std::size_t size_of_first);
void check_at_least(const char* name, std::size_t size, std::size_t needed);
void check_finite(const char* name, Points X);
// x on the surface; throws where it has no place on it.
Eigen::Vector3d on_surface(const char* name, const Eigen::Vector3d& x, ImageSurface surface);

}  // namespace framewise
