// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/geometry/place_noise.h"
#include "framewise/odometry/local_map.h"

namespace framewise {

// Features of a frame that no point is near: where points may be added.
std::vector<int> open_features(const MapFrame& frame, const std::vector<Eigen::Vector2d>& taken,
                               double apart_px);

// A feature of one frame found in another, to fractions of a pixel.
struct FeaturePair {
  int feature1, feature2;
  Eigen::Vector2d pixel2;
  Eigen::Vector3d ray2;  // on the plane z = 1
  PlaceNoise noise_px;
};

// Those features of frame 1 that are listed, among those listed of frame 2 within window_px of where they are
// expected (an entry for each of features1), by descriptors and then by patches.
std::vector<FeaturePair> pair_features(const MapFrame& frame1, const std::vector<int>& features1,
                                       const std::vector<cv::Point2f>& expected2, const MapFrame& frame2,
                                       const std::vector<int>& features2, const Camera& camera,
                                       double window_px);

struct GrowthOptions {
  double max_error_px = 2;          // of a point that both keyframes see, in each
  double max_relative_sigma = 0.3;  // of its inverse depth: less is known of it than whether it is there
  double least_sigma_px = 0.3;      // of a place found in another keyframe
};

// The point where the rays of a pair meet, hosted by camera 1; empty where they do not, or are as good as
// parallel.
std::optional<MapPoint> triangulated_point(const Eigen::Vector3d& ray1, const FeaturePair& pair,
                                           const Pose& cam2_from_cam1, double focal,
                                           const GrowthOptions& options);

// Adds to keyframe `older` the points that only it and `newer` see. Returns how many.
int grow_map(LocalMap& map, int older, int newer, const Camera& camera, const GrowthOptions& options = {});

}  // namespace framewise
