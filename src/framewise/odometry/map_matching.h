// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "framewise/geometry/place_noise.h"
#include "framewise/odometry/local_map.h"

namespace framewise {

// A point of the map that is a feature of a frame.
struct FeatureOfPoint {
  PointRef ref;
  int feature;
};

// By descriptors alone, among features within window_px of where the points are expected.
std::vector<FeatureOfPoint> match_in_window(const LocalMap& map, const std::vector<VisiblePoint>& points,
                                            const MapFrame& frame, double window_px);

// By descriptors alone, anywhere, to all points of one keyframe; what has a rival is left out.
std::vector<FeatureOfPoint> match_anywhere(const Keyframe& keyframe, const MapFrame& frame);

// Where a frame has a point of the map, to fractions of a pixel.
struct TrackedPoint {
  PointRef ref;
  Eigen::Vector2d pixel;
  Eigen::Vector3d ray;  // on the plane z = 1
  PlaceNoise noise_px;
};

// Looks for the hosts' patches, warped as a plane across the host's line of sight would be, around where the
// points are expected. coarser: levels above the patch's own that are looked at first, each doubling how far
// off the expectation may be. At most max_count, spread over the image.
std::vector<TrackedPoint> track_map_points(const LocalMap& map, const std::vector<VisiblePoint>& points,
                                           const MapFrame& frame, const Pose& world_from_cam,
                                           const Camera& camera, int coarser, int max_count);

// The level of a pyramid on which a feature of the host, warped so, has the size it was found at.
int level_of(const Keyframe& host, const MapPoint& point, const Eigen::Matrix2d& warp, int levels);

// track_patch from `coarser` levels above warp.level down to it.
std::optional<TrackedPatch> track_from_coarse(const ImageLevels& host, const ImageLevels& frame,
                                              PatchWarp warp, int coarser);

// How an offset from the point's pixel in the host, on a surface of that slope (MapPoint), looks in a camera;
// empty where either does not see it.
std::optional<Eigen::Matrix2d> warp_of_patch(const Eigen::Vector3d& x_in_host, const Pose& cam_from_host,
                                             const Camera& camera,
                                             const Eigen::Vector2d& slope = Eigen::Vector2d::Zero());

}  // namespace framewise
