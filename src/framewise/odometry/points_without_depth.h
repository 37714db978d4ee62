// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/odometry/map_placement.h"

namespace framewise {

// What a placed frame without depth says of how far the points are that it sees, and, of the newest
// keyframes, those whose depth is not known yet and that it was not placed by. Returns where the latter are.
std::vector<TrackedPoint> look_for_depth(LocalMap& map, const Placed& placed, const MapFrame& frame,
                                         const Pose& world_from_cam, const Camera& camera);

// Makes points, of a guessed depth, of those features of a keyframe that no point it sees is near. seen:
// these, which are what depths are guessed from.
void guess_points(LocalMap& map, int keyframe, const std::vector<TrackedPoint>& seen, const Camera& camera);

}  // namespace framewise
