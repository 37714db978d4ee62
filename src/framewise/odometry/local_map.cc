// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/local_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace framewise {
namespace {

// Seen from farther than twice or nearer than half, or from 45 degrees beside, a patch is another one.
bool is_seen_alike(const Eigen::Vector3d& x_in_host, const Eigen::Vector3d& x_in_cam,
                   const Eigen::Matrix3d& cam_from_host) {
  const double from = x_in_host.norm(), to = x_in_cam.norm();
  if (!(to > 0.45 * from && to < 2.2 * from)) return false;
  return (cam_from_host * x_in_host).dot(x_in_cam) > std::cos(M_PI / 4) * from * to;
}

double spread_px(const MapPoint& point, const Pose& cam_from_host, const Eigen::Vector3d& x_in_cam,
                 const Camera& camera) {
  const auto J = camera.project_jacobian(x_in_cam);
  if (!J) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d by_inverse_z = cam_from_host.R * point.ray / (point.inverse_z * point.inverse_z);
  return std::sqrt(point.variance) * (*J * by_inverse_z).norm();
}

std::optional<VisiblePoint> seen(const Keyframe& host, int index, const Pose& cam_from_host,
                                 const Camera& camera, const Shutter& shutter = {}) {
  const MapPoint& point = host.points[index];
  if (point.is_given_up) return std::nullopt;
  const Eigen::Vector3d x_in_host = point.position();
  const Eigen::Vector3d x_in_cam = cam_from_host * x_in_host;
  if (x_in_cam.z() <= 0 || !is_seen_alike(x_in_host, x_in_cam, cam_from_host.R)) return std::nullopt;
  const auto pixel = shutter.project(camera, x_in_cam);
  if (!pixel || !camera.contains(*pixel)) return std::nullopt;
  VisiblePoint visible{{host.id, index}, *pixel, x_in_cam};
  if (!point.is_known()) visible.spread_px = spread_px(point, cam_from_host, x_in_cam, camera);
  return visible;
}

// Of a sample of its points.
double share_in_view(const Keyframe& host, const Pose& cam_from_host, const Camera& camera) {
  constexpr int kSample = 24;
  const int size = static_cast<int>(host.points.size()), step = std::max(1, size / kSample);
  int looked_at = 0, in_view = 0;
  for (int i = 0; i < size; i += step)
    ++looked_at, in_view += seen(host, i, cam_from_host, camera).has_value();
  return looked_at >= kSample / 2 ? static_cast<double>(in_view) / looked_at : 0;
}

}  // namespace

void LocalMap::forget_oldest() {
  gone_.push_back(keyframes_.front().world_from_cam);
  keyframes_.pop_front();
}

Keyframe& LocalMap::add(std::shared_ptr<const MapFrame> frame, const Pose& world_from_cam) {
  if (static_cast<int>(keyframes_.size()) == capacity_) forget_oldest();
  keyframes_.push_back({next_id_++, std::move(frame), world_from_cam, {}, {}});
  return keyframes_.back();
}

void LocalMap::go_on_as(const LocalMap& other, const Pose& world_from_other) {
  while (!keyframes_.empty()) forget_oldest();
  const int shift = next_id_ - other.first_id();
  for (Keyframe keyframe : other.keyframes_) {
    keyframe.id += shift;
    keyframe.world_from_cam = world_from_other * keyframe.world_from_cam;
    for (MapPoint& point : keyframe.points)
      for (PointView& view : point.views) view.keyframe += shift;
    keyframes_.push_back(std::move(keyframe));
  }
  next_id_ += static_cast<int>(keyframes_.size());
}

void LocalMap::set_camera(const Camera& from, const Camera& to) {
  for (Keyframe& keyframe : keyframes_) {
    auto frame = std::make_shared<MapFrame>(*keyframe.frame);
    for (int i = 0; i < static_cast<int>(frame->rays.size()); ++i)
      if (const auto ray = plane_ray(to, frame->pixel(i))) frame->rays[i] = *ray;
    keyframe.frame = std::move(frame);
    for (MapPoint& point : keyframe.points)
      for (PointView& view : point.views) {
        const auto pixel = from.project(view.seen);
        const auto ray = pixel ? plane_ray(to, *pixel) : std::nullopt;
        if (ray) view.seen = *ray;
      }
  }
  if (!keyframes_.empty()) set_readout(keyframes_.front().shutter.readout, to);
}

void LocalMap::set_readout(double readout, const Camera& camera) {
  for (Keyframe& keyframe : keyframes_) keyframe.shutter.readout = readout;
  for (Keyframe& host : keyframes_)
    for (MapPoint& point : host.points) {
      const double row = row_of(camera, host.frame->pixel(point.feature).y());
      point.ray = host.shutter.at_middle(host.frame->rays[point.feature], row);
      for (PointView& view : point.views)
        if (holds(view.keyframe)) view.ray = at(view.keyframe).shutter.at_middle(view.seen, view.row);
    }
}

std::vector<int> keyframes_in_view(const LocalMap& map, const Pose& world_from_cam, const Camera& camera,
                                   int newest, int others) {
  constexpr double kLeastShare = 0.25;
  const Pose cam_from_world = world_from_cam.inverse();
  const int first_new = std::max(map.first_id(), map.newest_id() + 1 - newest);
  std::vector<std::pair<double, int>> ranked;
  for (int id = map.first_id(); id < first_new; ++id) {
    const double share = share_in_view(map.at(id), cam_from_world * map.at(id).world_from_cam, camera);
    if (share > kLeastShare) ranked.emplace_back(-share, id);
  }
  std::sort(ranked.begin(), ranked.end());
  if (static_cast<int>(ranked.size()) > others) ranked.resize(others);
  std::vector<int> ids;
  for (const auto& [share, id] : ranked) ids.push_back(id);
  for (int id = first_new; id <= map.newest_id(); ++id) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<VisiblePoint> points_in_view(const LocalMap& map, const std::vector<int>& keyframes,
                                         const Pose& world_from_cam, const Camera& camera,
                                         const Shutter& shutter) {
  std::vector<VisiblePoint> points;
  const Pose cam_from_world = world_from_cam.inverse();
  for (const int id : keyframes) {
    const Keyframe& host = map.at(id);
    const Pose cam_from_host = cam_from_world * host.world_from_cam;
    for (int i = 0; i < static_cast<int>(host.points.size()); ++i)
      if (const auto point = seen(host, i, cam_from_host, camera, shutter)) points.push_back(*point);
  }
  return points;
}

std::vector<VisiblePoint> settled(const std::vector<VisiblePoint>& points, double max_spread_px) {
  std::vector<VisiblePoint> near;
  for (const VisiblePoint& point : points)
    if (point.spread_px <= max_spread_px) near.push_back(point);
  return near;
}

}  // namespace framewise
