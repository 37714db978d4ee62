// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "framewise/features/features.h"
#include "framewise/features/warped_patch.h"
#include "framewise/geometry/camera.h"
#include "framewise/image/depth_plane.h"
#include "framewise/image/frame.h"
#include "framewise/odometry/options.h"

namespace framewise {

// What tracking against a map looks at in a frame.
struct MapFrame {
  std::size_t index = 0;
  double time = 0;  // s
  Features features;
  std::vector<Eigen::Vector3d> rays;  // of the features, on the plane z = 1
  ImageLevels levels;                 // of the gray image; empty where there is none
  cv::Mat depth;                      // as in Frame, with its delay
  bool has_depth = false;             // kept when the image is let go
  double depth_delay = 0;
  bool is_described = false;
  std::optional<Features> found;  // for describe to take, which chooses those that have a ray

  Eigen::Vector2d pixel(int feature) const {
    return {features.keypoints[feature].pt.x, features.keypoints[feature].pt.y};
  }
};

// Without features, and without a depth image that tells nothing. Pure: frames are looked at side by side.
MapFrame look_at(const Frame& frame, std::size_t index);

// What describe looks for, ahead of it: needs no camera.
void find_features(MapFrame& frame, const MapOptions& options);

// Finds its features, unless it has them. Where a map foretells what a frame shows, patches are enough: only
// keyframes and frames that are not where they were expected need features.
void describe(MapFrame& frame, const Camera& camera, const MapOptions& options);

// The ray on the plane z = 1 that projects to a pixel; empty where there is none that looks forward.
std::optional<Eigen::Vector3d> plane_ray(const Camera& camera, const Eigen::Vector2d& pixel);

// The surface that a frame's gray image shows along a ray, with the plane around it within plane_reach_px.
// The depth image may have been taken while the camera stood elsewhere, at depth_from_cam, and shows the same
// point at another pixel and depth.
std::optional<DepthPlane> depth_along(const MapFrame& frame, const Eigen::Vector3d& ray,
                                      const Pose& depth_from_cam, const Camera& camera,
                                      const OdometryOptions& options);

}  // namespace framewise
