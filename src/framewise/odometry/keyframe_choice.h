// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "framewise/geometry/pose.h"
#include "framewise/odometry/map_options.h"

namespace framewise {

// What says whether a placed frame is to become a keyframe.
struct KeyframeNeed {
  int known = 0;                   // points of known depth that it sees and that agree
  int known_at_keyframe = 0;       // that the newest keyframe saw
  bool lives_on_motion = false;    // without depth nothing else tells how far things are
  std::optional<double> shift_px;  // see median_shift
};

// It sees too little of what the newest keyframe saw, or has moved enough for points to be triangulated.
bool wants_keyframe(const KeyframeNeed& need, int image_width, const MapOptions& options);

// Whether the last keyframes and their points are adjusted together when one is added. Without depth, which
// needs it, always; "auto": with depth where the frame directly before is a keyframe as well and the motion
// between them has shifted what is seen. Of a slow camera's points the frames between keyframes tell more
// than an adjustment, which does not have them, and a turn tells it nothing.
bool needs_adjustment(const KeyframeNeed& need, bool follows_keyframe, int image_width,
                      const MapOptions& options);

// How far a camera's motion, its turn apart, has shifted what it sees: the median over points, on the plane
// z = 1. Empty where none is before both cameras.
std::optional<double> median_shift(const std::vector<Eigen::Vector3d>& x_in_keyframe,
                                   const Pose& world_from_keyframe, const Pose& world_from_cam);

}  // namespace framewise
