// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "framewise/features/features.h"
#include "framewise/features/tracking.h"
#include "framewise/geometry/camera.h"
#include "framewise/image/depth.h"
#include "framewise/image/frame.h"
#include "framewise/odometry/input_image.h"
#include "framewise/odometry/options.h"

namespace framewise {

// What a camera saw at a pixel.
struct Sighting {
  Bearing bearing;  // unit length
  double z;         // depth along the optical axis (m); NaN where unknown
};

// What odometry keeps of a frame: its images and its features with their bearings and depths.
// sightings[i] belongs to features.keypoints[i].
struct Observation {
  double time = 0;    // s
  std::string input;  // the image that the features were found in, by its name (InputImage::chosen)
  Features features;
  std::vector<Sighting> sightings;  // features that the lens model cannot explain are left out
  cv::Mat gray;                     // that the features were found in
  cv::Mat depth;                    // as in Frame; empty where no pixel has a depth that is used
  TrackedImage scales;              // of gray; only where features are tracked (matcher klt)
};

// Empty where the lens model has no bearing for the pixel.
std::optional<Sighting> sight(const cv::Mat& depth, const cv::Point2f& pixel, const Camera& camera,
                              const DepthLookupOptions& options);

// Looks at a frame once, for the pairs before and after it. Without the image that `input` takes, nothing is
// seen.
Observation observe(const Frame& frame, const InputImage& input, const Camera& camera,
                    const OdometryOptions& options);
// The same for one frame alone: input is made for it.
Observation observe(const Frame& frame, const Camera& camera, const OdometryOptions& options);

}  // namespace framewise
