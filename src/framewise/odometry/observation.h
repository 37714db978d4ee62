// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "framewise/features/features.h"
#include "framewise/geometry/camera.h"
#include "framewise/image/depth.h"
#include "framewise/image/frame.h"

namespace framewise {

// What odometry keeps of a frame: its features with their bearings and, where depth is known, their points.
// bearings[i] and points[i] belong to features.keypoints[i].
struct Observation {
  double time = 0;  // s
  Features features;
  std::vector<Bearing> bearings;        // unit length; features the lens model cannot explain are left out
  std::vector<Eigen::Vector3d> points;  // in the camera (m); NaN where depth is unknown
  bool has_depth = false;               // the frame came with a depth image
};

Observation observe(const Frame& frame, const Camera& camera, const FeatureOptions& features,
                    const DepthLookupOptions& depth);

}  // namespace framewise
