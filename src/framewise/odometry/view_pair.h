// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "framewise/odometry/frame_pair.h"
#include "framewise/odometry/local_map.h"
#include "framewise/odometry/two_view_start.h"

namespace framewise {

// What a map knows of the depths that a camera sees.
struct KnownDepth {
  Eigen::Vector2d pixel;
  double z;               // m, or the map's unit
  double relative_sigma;  // of z
};

std::vector<KnownDepth> known_depths(const LocalMap& map, const std::vector<int>& keyframes,
                                     const Pose& world_from_cam, const Camera& camera);

// The length of a motion whose two views are triangulated with length 1: what the depths known in camera 1
// are of those, z = length z_1, the median weighed by how certain both are. Empty where too few agree.
struct MotionLength {
  double value, relative_sigma;
};
std::optional<MotionLength> length_by_known(const TwoViewStart& two_views, const MapFrame& frame1,
                                            const std::vector<KnownDepth>& known);

// cam2_from_cam1 by two views.
struct ViewPose {
  MapPose pose;
  bool is_guess = false;  // its translation, in length or in all
};

// pose_from_pair's twin for a first frame without depth: five points in RANSAC on features found anywhere in
// both images tell the motion but for its length, which is that by the known depths. A motion that is not
// told from a turn is 0. Where the length or the direction is not known, it is that of the prior. Empty where
// too little is seen by both.
std::optional<ViewPose> pose_from_views(FrameView& first, FrameView& second, const Pose& prior,
                                        const std::vector<KnownDepth>& known, const Camera& camera,
                                        const RansacOptions& ransac);

}  // namespace framewise
