// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/observation.h"

#include <limits>
#include <opencv2/core.hpp>

namespace framewise {
namespace {

// Whether any pixel has a depth that the options use.
bool knows_depth(const cv::Mat& depth, const DepthLookupOptions& options) {
  if (depth.empty()) return false;
  cv::Mat known;
  cv::inRange(depth, options.min_depth, options.max_depth, known);
  return cv::countNonZero(known) > 0;
}

}  // namespace

std::optional<Sighting> sight(const cv::Mat& depth, const cv::Point2f& point, const Camera& camera,
                              const DepthLookupOptions& options) {
  const Eigen::Vector2d pixel(point.x, point.y);
  const auto bearing = camera.bearing(pixel);
  if (!bearing) return std::nullopt;
  Sighting sighting{*bearing, std::numeric_limits<double>::quiet_NaN()};
  if (!depth.empty() && bearing->z() > 0)
    if (const auto z = depth_at(depth, pixel, options)) sighting.z = *z;
  return sighting;
}

Observation observe(const Frame& frame, const InputImage& input, const Camera& camera,
                    const OdometryOptions& options) {
  Observation observation;
  observation.time = frame.time;
  observation.input = input.chosen(frame);
  observation.gray = input.of(frame);
  if (knows_depth(frame.depth, options.depth)) observation.depth = frame.depth;
  if (observation.gray.empty()) return observation;
  FeatureOptions feature_options = options.features;
  feature_options.describe = !options.tracks();
  const Features found = extract_features(observation.gray, feature_options);
  if (options.tracks()) observation.scales = tracked_image(observation.gray, options.track);
  Features& kept = observation.features;
  kept.finest_size = found.finest_size;
  for (int i = 0; i < static_cast<int>(found.keypoints.size()); ++i) {
    const auto sighting = sight(frame.depth, found.keypoints[i].pt, camera, options.depth);
    if (!sighting) continue;
    kept.keypoints.push_back(found.keypoints[i]);
    if (!found.descriptors.empty()) kept.descriptors.push_back(found.descriptors.row(i));
    observation.sightings.push_back(*sighting);
  }
  return observation;
}

Observation observe(const Frame& frame, const Camera& camera, const OdometryOptions& options) {
  return observe(frame, InputImage(options.input, camera, options.depth.max_depth), camera, options);
}

}  // namespace framewise
