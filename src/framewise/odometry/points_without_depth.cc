// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/points_without_depth.h"

#include <algorithm>
#include <cmath>

#include "framewise/odometry/depth_filter.h"

namespace framewise {

std::vector<TrackedPoint> look_for_depth(LocalMap& map, const Placed& placed, const MapFrame& frame,
                                         const Pose& world_from_cam, const Camera& camera) {
  constexpr int kBack = 4;
  constexpr double kMaxErrorPx = 2, kSurePx = 0.5, kWellKnown = 0.03;
  const double focal = std::abs(camera.fx);
  const Pose cam_from_world = world_from_cam.inverse();
  std::vector<PointRef> tracked;
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const PointRef& ref = placed.points[i].ref;
    tracked.push_back(ref);
    MapPoint& point = map.point(ref);
    if (!placed.pose.inliers[i] || point.is_given_up ||
        point.variance < std::pow(kWellKnown * point.inverse_z, 2))
      continue;
    const Pose cam_from_host = cam_from_world * map.at(ref.keyframe).world_from_cam;
    take_in(point, placed.matches[i].ray, std::max(kSurePx, placed.points[i].noise_px.sigma) / focal,
            cam_from_host, kMaxErrorPx / focal);
  }
  std::vector<int> newest;
  for (int id = std::max(map.first_id(), map.newest_id() + 1 - kBack); id <= map.newest_id(); ++id)
    newest.push_back(id);
  return trace_points(map, newest, tracked, frame, world_from_cam, placed.shutter, camera);
}

void guess_points(LocalMap& map, int keyframe, const std::vector<TrackedPoint>& seen, const Camera& camera) {
  const Pose cam_from_world = map.at(keyframe).world_from_cam.inverse();
  std::vector<Eigen::Vector2d> places;
  std::vector<DepthAtPixel> known;
  for (const TrackedPoint& point : seen) {
    places.push_back(point.pixel);
    if (!map.holds(point.ref.keyframe)) continue;
    const MapPoint& map_point = map.point(point.ref);
    const double z =
        (cam_from_world * (map.at(point.ref.keyframe).world_from_cam * map_point.position())).z();
    if (map_point.is_known() && z > 0) known.push_back({point.pixel, 1 / z});
  }
  add_guessed_points(map.at(keyframe), places, known, camera);
}

}  // namespace framewise
