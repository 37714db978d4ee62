// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>

#include "framewise/geometry/pose.h"

namespace framewise {

// world_from_cam at any time (s); optical axes (x right, y down, z forward), z of the world up.
using Path = std::function<Pose(double time)>;

// Carried around the middle of a space for as long as one likes, looking across it and about: an ellipse with
// sums of sines in distance, height, heading, pitch and roll, and a hand's tremor. All derivatives are
// continuous. In a box of 4 m x 3 m it moves at 0.15 to 0.55 m/s and turns at up to 30 deg/s. Never leaves
// the box.
Path handheld_path(const Eigen::AlignedBox3d& free_space, std::uint64_t seed);

}  // namespace framewise
