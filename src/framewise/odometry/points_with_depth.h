// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/odometry/map_placement.h"

namespace framewise {

// Makes points of those features of a keyframe that have depth and no point near. taken: points that other
// keyframes host and this one sees. depth_from_cam: as for depth_along.
void add_points_with_depth(Keyframe& keyframe, const std::vector<TrackedPoint>& taken,
                           const Pose& depth_from_cam, const Camera& camera, const OdometryOptions& options);

// One more look at a point's inverse depth, with its sigma: taken in unless it is more than three sigma off
// or the point is known as well as ten looks tell it, for depth errors of one place are alike from frame to
// frame.
void take_in_depth(MapPoint& point, double inverse_z, double sigma);

// What a placed frame's depth image says of the points it sees.
void take_in_depths(LocalMap& map, const Placed& placed, const Pose& world_from_cam, const DepthNoise& noise);

}  // namespace framewise
