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

// Those of a frame's features that its depth image tells.
std::vector<KnownDepth> known_depths(const MapFrame& frame, const Camera& camera,
                                     const OdometryOptions& options);

// The length of a motion whose two views are triangulated with length 1: what the depths known in camera 1
// are of those, z = length z_1, the median weighed by how certain both are. Empty where too few agree.
struct MotionLength {
  double value, relative_sigma;
};
std::optional<MotionLength> length_by_known(const TwoViewStart& two_views, const MapFrame& frame1,
                                            const std::vector<KnownDepth>& known);

// The translation of cam2_from_cam1 whose rotation two views have told: that with which most of the known
// depths agree, of two each in RANSAC, refined. Empty where few agree, or less than half.
struct KnownTranslation {
  Eigen::Vector3d t;            // m, or the map's unit
  Eigen::Matrix3d covariance;   // with the rotation as it is
  Eigen::Matrix3d by_rotation;  // d t / d rotation, where that becomes R exp(rotation)
};
std::optional<KnownTranslation> translation_by_known(const TwoViewStart& two_views, const MapFrame& frame1,
                                                     const std::vector<KnownDepth>& known,
                                                     const Camera& camera, std::uint64_t seed);

// cam2_from_cam1 by two views.
struct ViewPose {
  MapPose pose;
  bool is_guess = false;  // its translation, in length or in all
  bool is_far = false;    // what both see, or right ahead: it shows a turn and hardly a translation
};

// pose_from_pair's twin for a first frame without depth, or with little: five points in RANSAC on features
// found anywhere in both images tell the motion but for its length, which is that by the known depths. Where
// all is far, so that they tell the rotation alone, the known depths tell the translation. A motion that they
// do not tell from a turn is 0; a length or a direction that they do not tell is that of the prior. Empty
// where too little is seen by both.
std::optional<ViewPose> pose_from_views(FrameView& first, FrameView& second, const Pose& prior,
                                        const std::vector<KnownDepth>& known, const Camera& camera,
                                        const RansacOptions& ransac);

}  // namespace framewise
