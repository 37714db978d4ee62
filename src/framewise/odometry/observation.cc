// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/observation.h"

#include <limits>

namespace framewise {
namespace {

Eigen::Vector3d point_at(const cv::Mat& depth, const Eigen::Vector2d& pixel, const Bearing& bearing,
                         const DepthLookupOptions& options) {
  if (!depth.empty() && bearing.z() > 0)
    if (const auto z = depth_at(depth, pixel, options)) return (*z / bearing.z()) * bearing;
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Observation observe(const Frame& frame, const Camera& camera, const FeatureOptions& feature_options,
                    const DepthLookupOptions& depth_options) {
  Features found = extract_features(frame.gray, feature_options);
  Observation observation;
  observation.time = frame.time;
  observation.has_depth = !frame.depth.empty();
  Features& kept = observation.features;
  kept.finest_size = found.finest_size;
  for (int i = 0; i < static_cast<int>(found.keypoints.size()); ++i) {
    const cv::KeyPoint& keypoint = found.keypoints[i];
    const Eigen::Vector2d pixel(keypoint.pt.x, keypoint.pt.y);
    const auto bearing = camera.bearing(pixel);
    if (!bearing) continue;
    kept.keypoints.push_back(keypoint);
    kept.descriptors.push_back(found.descriptors.row(i));
    observation.bearings.push_back(*bearing);
    observation.points.push_back(point_at(frame.depth, pixel, *bearing, depth_options));
  }
  return observation;
}

}  // namespace framewise
