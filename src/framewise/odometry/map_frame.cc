// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_frame.h"

#include <utility>

namespace framewise {

namespace {

// Of a sample of its pixels one in a hundred: fewer tell a pose nothing, and a frame is better off as one
// without depth.
bool tells_depth(const cv::Mat& depth) {
  constexpr int kStep = 4, kOneIn = 100;
  int looked_at = 0, valid = 0;
  for (int v = 0; v < depth.rows; v += kStep)
    for (int u = 0; u < depth.cols; u += kStep) ++looked_at, valid += depth.at<float>(v, u) > 0;
  return kOneIn * valid > looked_at;
}

}  // namespace

MapFrame look_at(const Frame& frame, std::size_t index) {
  MapFrame seen;
  seen.index = index;
  seen.time = frame.time;
  if (tells_depth(frame.depth)) seen.depth = frame.depth;
  seen.has_depth = !seen.depth.empty();
  seen.depth_delay = frame.depth_delay;
  if (!frame.gray.empty()) seen.levels = image_levels(frame.gray);
  return seen;
}

void find_features(MapFrame& frame, const MapOptions& options) {
  if (frame.levels.empty()) return;
  FeatureOptions feature_options;
  feature_options.count = options.features;
  feature_options.spread = options.spread;
  frame.found = extract_features(frame.levels[0], feature_options);
}

void describe(MapFrame& frame, const Camera& camera, const MapOptions& options) {
  if (frame.is_described) return;
  frame.is_described = true;
  if (!frame.found) find_features(frame, options);
  if (!frame.found) return;
  const Features found = std::move(*frame.found);
  frame.found.reset();
  frame.features.finest_size = found.finest_size;
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(found.keypoints.size()); ++i) {
    const cv::Point2f& p = found.keypoints[i].pt;
    const auto ray = plane_ray(camera, {p.x, p.y});
    if (!ray) continue;
    kept.push_back(i);
    frame.rays.push_back(*ray);
    frame.features.keypoints.push_back(found.keypoints[i]);
  }
  frame.features.descriptors.create(static_cast<int>(kept.size()), found.descriptors.cols,
                                    found.descriptors.type());
  for (std::size_t i = 0; i < kept.size(); ++i)
    found.descriptors.row(kept[i]).copyTo(frame.features.descriptors.row(static_cast<int>(i)));
}

std::optional<Eigen::Vector3d> plane_ray(const Camera& camera, const Eigen::Vector2d& pixel) {
  constexpr double kLeastZ = 0.17;  // 80 degrees off the axis
  const auto bearing = camera.bearing(pixel);
  if (!bearing || bearing->z() < kLeastZ) return std::nullopt;
  return *bearing / bearing->z();
}

std::optional<DepthPlane> depth_along(const MapFrame& frame, const Eigen::Vector3d& ray,
                                      const Pose& depth_from_cam, const Camera& camera,
                                      const OdometryOptions& options) {
  if (frame.depth.empty()) return std::nullopt;
  const Eigen::Vector3d turned = depth_from_cam.R * ray;
  const auto pixel = camera.project(turned);
  if (!pixel || turned.z() <= 0) return std::nullopt;
  std::optional<DepthPlane> plane;
  DepthPlaneOptions around;
  around.reach_px = options.map.plane_reach_px;
  if (around.reach_px > 0)
    plane = depth_plane_at(frame.depth, *pixel, camera, options.depth_noise, options.depth, around);
  else if (const auto z = depth_at(frame.depth, *pixel, options.depth))
    plane = DepthPlane{*z};
  if (!plane) return std::nullopt;
  const Eigen::Vector3d in_depth_cam = turned * (plane->z / turned.z());
  plane->z = (depth_from_cam.inverse() * in_depth_cam).z();
  return plane->z > 0 ? plane : std::nullopt;
}

}  // namespace framewise
