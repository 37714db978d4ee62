// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/points_with_depth.h"

#include <cmath>

#include "framewise/odometry/taken_places.h"

namespace framewise {

void add_points_with_depth(Keyframe& keyframe, const std::vector<TrackedPoint>& taken,
                           const Pose& depth_from_cam, const Camera& camera, const OdometryOptions& options) {
  const MapFrame& frame = *keyframe.frame;
  if (frame.levels.empty()) return;
  constexpr double kApartPx = 6;
  TakenPlaces places(frame.levels[0].size(), kApartPx);
  for (const TrackedPoint& point : taken) places.take(point.pixel);
  for (int i = 0; i < static_cast<int>(frame.rays.size()); ++i) {
    const Eigen::Vector2d pixel = frame.pixel(i);
    if (!places.is_free(pixel)) continue;
    const auto plane = depth_along(frame, frame.rays[i], depth_from_cam, camera, options);
    if (!plane) continue;
    places.take(pixel);
    const double row = row_of(camera, pixel.y());
    const double z_middle = keyframe.shutter.depth_at_middle(frame.rays[i], row, plane->z);
    const double sigma = plane->noise_share * options.depth_noise.sigma(z_middle) / (z_middle * z_middle);
    MapPoint point{
        i, keyframe.shutter.at_middle(frame.rays[i], row), 1 / z_middle, sigma * sigma, 0, 0, {}, 0, 0};
    point.slope = plane->slope;
    point.measured = point.inverse_z;
    point.information = 1 / point.variance;
    keyframe.points.push_back(point);
  }
}

void take_in_depth(MapPoint& point, double inverse_z, double sigma) {
  constexpr double kMostLooks = 10;
  const double information = 1 / (sigma * sigma);
  if (std::abs(inverse_z - point.inverse_z) > 3 * std::sqrt(point.variance + sigma * sigma)) return;
  if (point.information >= kMostLooks * information) return;
  const double sum = point.information + information;
  point.measured = (point.information * point.measured + information * inverse_z) / sum;
  point.information = sum;
  const double known = 1 / point.variance;
  point.inverse_z = (known * point.inverse_z + information * inverse_z) / (known + information);
  point.variance = 1 / (known + information);
}

void take_in_depths(LocalMap& map, const Placed& placed, const Pose& world_from_cam,
                    const DepthNoise& noise) {
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const MapMatch& match = placed.matches[i];
    if (!placed.pose.inliers[i] || !(match.z > 0)) continue;
    const PointRef& ref = placed.points[i].ref;
    const Pose host_from_cam = map.at(ref.keyframe).world_from_cam.inverse() * world_from_cam;
    const double z = (host_from_cam * (match.z * match.ray)).z();
    if (!(z > 0)) continue;
    const double sigma = placed.pose.depth_scale * match.z_share * noise.sigma(match.z);
    take_in_depth(map.point(ref), 1 / z, sigma / (z * z));
  }
}

}  // namespace framewise
