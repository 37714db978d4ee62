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
  int known = 0;              // points of known depth that it sees and that agree
  int known_at_keyframe = 0;  // that the newest keyframe saw
  // Only without depth, where motion alone tells how far things are: see median_shift, in pixels.
  bool lives_on_motion = false;
  std::optional<double> shift_px;
};

// It sees too little of what the newest keyframe saw, or has moved enough for points to be triangulated.
bool wants_keyframe(const KeyframeNeed& need, int image_width, const MapOptions& options);

// How far a camera's motion, its turn apart, has shifted what it sees: the median over points, on the plane
// z = 1. Empty where none is before both cameras.
std::optional<double> median_shift(const std::vector<Eigen::Vector3d>& x_in_keyframe,
                                   const Pose& world_from_keyframe, const Pose& world_from_cam);

}  // namespace framewise
