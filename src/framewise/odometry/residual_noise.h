// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "framewise/odometry/local_map.h"

namespace framewise {

// A point of the map that a camera was placed by.
struct PlacedBy {
  PointRef ref;
  Eigen::Vector3d x_in_cam;      // where the map has it (m)
  Eigen::Matrix3d S;             // its covariance there, its host's pose apart (m^2)
  Eigen::Vector2d ray_residual;  // on the plane z = 1: where the map has it - where it is seen
  PlaceNoise ray_noise;          // of that, as the residuals show it
  double z_residual = 0;         // likewise of its depth (m)
  double z_sigma = 0;            // 0: its depth counted for nothing
};

// d (ray on the plane z = 1, depth) / d x_in_cam; without depth the last row is zero.
Eigen::Matrix3d measured_by_position(const PlacedBy& point);

// How many times larger the variances of sums over neighbouring residuals are than if they were independent:
// 1 or more.
struct Likeness {
  double ray, z;
};
Likeness likeness_of_neighbours(const std::vector<PlacedBy>& points);

// Mean squares of residuals over the variances that they are said to have: robust scales do not see tails. 1
// where there are none.
struct ResidualTails {
  double ray, z;
};
ResidualTails residual_tails(const std::vector<PlacedBy>& points);

// Share of the variances said that is new in each frame: half the mean square of what residuals changed by.
struct ResidualChanges {
  double ray = 1, z = 1;
};

}  // namespace framewise
