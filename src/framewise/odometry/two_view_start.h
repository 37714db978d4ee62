// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "framewise/odometry/map_growth.h"
#include "framewise/odometry/map_matching.h"

namespace framewise {

struct TwoViewOptions {
  double max_error_px = 1.5;  // Sampson's, of a pair that agrees
  int min_pairs = 40;         // fewer agree by chance, or see too little of the image
  int min_points = 40;        // triangulated, for a map to begin with
  // Angle between the rays of a point (deg) that half of the points must have: smaller ones tell the camera's
  // turn from its motion too badly to build on. min_points are enough where the direction of the motion is as
  // sure as this (deg, one sigma): before a road, most is far.
  double min_parallax_deg = 0.4, sure_direction_deg = 0.5;
  double farthest = 0.25;  // that a feature may move from one to the other, of an image's width
  RansacOptions ransac;
};

// Whether a motion is told from a turn by the angles (rad) between the rays of its points, and the variance
// of its direction (rad^2).
bool shows_motion(const std::vector<double>& angles, double direction_variance,
                  const TwoViewOptions& options);

// How two cameras without depth stand to each other.
struct TwoViewStart {
  enum class Kind {
    kUnrelated,    // they see too little in common
    kTurned,       // or moved too little: the rotation is known
    kTriangulated  // the motion is known up to its length, which is 1, and points in camera 1
  };
  Kind kind = Kind::kUnrelated;
  EstimateKind support = EstimateKind::kFull;  // of the motion, where they are not unrelated
  Pose cam2_from_cam1;
  Matrix6d covariance = Matrix6d::Zero();  // of the tangent (rotation, translation), as Estimate has it
  int pairs = 0, inliers = 0, iterations = 0;
  std::vector<FeaturePair> agreeing;  // with the motion, or the turn
  std::vector<MapPoint> points;       // hosted by camera 1,
  std::vector<FeaturePair> seen_by;   // and where camera 2 has each
};

// The first two views of a map.
//   Nistér, An efficient solution to the five-point relative pose problem, PAMI 2004.
TwoViewStart start_from_two_views(const MapFrame& frame1, const MapFrame& frame2, const Camera& camera,
                                  const TwoViewOptions& options);

// The motion's length (m) by the depth image of camera 2: the median of what its points say. Empty where too
// few have depth there.
std::optional<double> length_by_depth(const TwoViewStart& two_views, const MapFrame& frame2,
                                      const Camera& camera, const OdometryOptions& options);

// A map's first points, where either keyframe has them.
struct SeenByBoth {
  std::vector<TrackedPoint> by_first, by_second;
};

// Makes camera 2 a keyframe, its motion from camera 1, the map's newest keyframe, of a length, and gives the
// points to camera 1.
SeenByBoth add_two_views(LocalMap& map, std::shared_ptr<const MapFrame> frame2, const TwoViewStart& two_views,
                         double length, const Camera& camera, const MapOptions& options);

}  // namespace framewise
