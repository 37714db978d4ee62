// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/depth_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "framewise/features/patch_search.h"
#include "framewise/odometry/map_growth.h"

namespace framewise {
namespace {

constexpr double kNoisePx = 0.5;   // of a place found by a patch: poses err as well, and alike in neighbours
constexpr double kMaxErrorPx = 2;  // off the epipolar line
constexpr double kMostSigmas = 2.5;  // that a guess is looked for within
constexpr double kShortPx = 3;       // an epipolar segment that a patch finds its own way on

// Where a point may be in a camera, from as far to as near as it may be.
struct Segment {
  Eigen::Vector2d from, middle, to;
};

std::optional<Segment> epipolar_segment(const MapPoint& point, const Pose& cam_from_host,
                                        const Shutter& shutter, const Camera& camera) {
  const double sigma = std::sqrt(point.variance);
  const auto pixel_at = [&](double inverse_z) -> std::optional<Eigen::Vector2d> {
    const Eigen::Vector3d x = cam_from_host.R * point.ray + inverse_z * cam_from_host.t;
    if (x.z() <= 0.05) return std::nullopt;
    return shutter.project(camera, x);
  };
  const auto far = pixel_at(std::max(0.02 * point.inverse_z, point.inverse_z - kMostSigmas * sigma));
  const auto middle = pixel_at(point.inverse_z);
  if (!far || !middle) return std::nullopt;
  for (double sigmas = kMostSigmas; sigmas > 0.1; sigmas *= 0.5)
    if (const auto near = pixel_at(point.inverse_z + sigmas * sigma)) {
      const cv::Rect image(-camera.width, -camera.height, 3 * camera.width, 3 * camera.height);
      if (image.contains({static_cast<int>(near->x()), static_cast<int>(near->y())}))
        return Segment{*far, *middle, *near};
    }
  return std::nullopt;
}

// Those parts of it that the image has.
std::optional<Segment> within(const Camera& camera, Segment segment) {
  if (camera.contains(segment.from) && camera.contains(segment.to)) return segment;
  cv::Point from(static_cast<int>(segment.from.x()), static_cast<int>(segment.from.y()));
  cv::Point to(static_cast<int>(segment.to.x()), static_cast<int>(segment.to.y()));
  if (!cv::clipLine(cv::Size(camera.width, camera.height), from, to)) return std::nullopt;
  segment.from = {from.x, from.y}, segment.to = {to.x, to.y};
  if (!camera.contains(segment.middle)) segment.middle = 0.5 * (segment.from + segment.to);
  return segment;
}

std::optional<TrackedPatch> found_along(const Keyframe& host, const MapPoint& point, const MapFrame& frame,
                                        const Segment& segment, const Eigen::Matrix2d& warp) {
  const int levels = static_cast<int>(frame.levels.size());
  const int finest = level_of(host, point, warp, levels);
  const double length = (segment.to - segment.from).norm();
  PatchWarp patch{host.frame->pixel(point.feature), segment.middle, warp, finest};
  if (length < std::ldexp(kShortPx, finest)) return track_patch(host.frame->levels, frame.levels, patch);
  constexpr double kLongPx = 80;
  while (length > std::ldexp(kLongPx, patch.level) && patch.level + 1 < levels) ++patch.level;
  patch.pixel2 = segment.from;
  const auto place = search_patch(host.frame->levels, frame.levels, patch, segment.to);
  if (!place) return std::nullopt;
  patch.pixel2 = *place;
  const int coarser = patch.level - finest;
  patch.level = finest;
  return track_from_coarse(host.frame->levels, frame.levels, patch, coarser);
}

}  // namespace

std::optional<InverseDepth> guessed_inverse_depth(const std::vector<DepthAtPixel>& known,
                                                  const Eigen::Vector2d& pixel) {
  if (known.empty()) return std::nullopt;
  constexpr std::size_t kNeighbours = 5;
  std::array<std::pair<double, double>, kNeighbours> nearest;  // squared distance, inverse depth
  std::size_t count = 0;
  for (const DepthAtPixel& depth : known) {
    const std::pair candidate{(depth.pixel - pixel).squaredNorm(), depth.inverse_z};
    if (count == kNeighbours && candidate.first >= nearest[count - 1].first) continue;
    std::size_t at = count < kNeighbours ? count++ : kNeighbours - 1;
    for (; at > 0 && candidate.first < nearest[at - 1].first; --at) nearest[at] = nearest[at - 1];
    nearest[at] = candidate;
  }
  std::array<double, kNeighbours> values;
  for (std::size_t i = 0; i < count; ++i) values[i] = nearest[i].second;
  std::sort(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  const double middle = values[count / 2];
  return InverseDepth{middle, std::max(0.5 * middle, 0.5 * (values[count - 1] - values[0]))};
}

int add_guessed_points(Keyframe& keyframe, const std::vector<Eigen::Vector2d>& taken,
                       const std::vector<DepthAtPixel>& known, const Camera& camera) {
  constexpr double kApartPx = 6;
  const MapFrame& frame = *keyframe.frame;
  int added = 0;
  for (const int feature : open_features(frame, taken, kApartPx)) {
    const Eigen::Vector2d pixel = frame.pixel(feature);
    const auto guess = guessed_inverse_depth(known, pixel);
    if (!guess || !(guess->value > 0)) continue;
    MapPoint point{};
    point.feature = feature;
    point.ray = keyframe.shutter.at_middle(frame.rays[feature], row_of(camera, pixel.y()));
    point.inverse_z = point.measured = guess->value;
    point.variance = guess->sigma * guess->sigma;
    point.information = 0.25 / point.variance;  // neighbours may be of another surface
    keyframe.points.push_back(point);
    ++added;
  }
  return added;
}

bool take_in(MapPoint& point, const Eigen::Vector3d& ray, double sigma, const Pose& cam_from_host,
             double max_error) {
  // ray x (a + inverse_z t) = m + inverse_z n.
  const Eigen::Vector3d a = cam_from_host.R * point.ray, &t = cam_from_host.t;
  const Eigen::Vector2d n = t.head<2>() - t.z() * ray.head<2>(), m = a.head<2>() - a.z() * ray.head<2>();
  const double n2 = n.squaredNorm(), spread = std::sqrt(point.variance);
  const double wanted = -n.dot(m) / std::max(n2, 1e-300);
  const double z =
      a.z() + t.z() * std::clamp(wanted, point.inverse_z - 3 * spread, point.inverse_z + 3 * spread);
  if (!(z > 0)) return false;
  const double off_line = n2 > 0 ? std::abs(m.x() * n.y() - m.y() * n.x()) / std::sqrt(n2) : m.norm();
  if (!(off_line <= max_error * z)) return false;
  const double information = n2 / (z * z * sigma * sigma), known = 1 / point.variance;
  const double gap = wanted - point.inverse_z;
  constexpr double kAgreeing = 3;
  if (!(gap * gap * information * known <= kAgreeing * kAgreeing * (information + known))) return false;
  const double moved = point.inverse_z + information / (information + known) * gap;
  constexpr double kFarthest = 0.05;  // of what it was taken for: further away is the same
  point.inverse_z = std::max(kFarthest * point.inverse_z, moved);
  point.variance = 1 / (information + known);
  return true;
}

std::vector<TrackedPoint> trace_points(LocalMap& map, const std::vector<int>& keyframes,
                                       const std::vector<PointRef>& tracked, const MapFrame& frame,
                                       const Pose& world_from_cam, const Shutter& shutter,
                                       const Camera& camera) {
  std::vector<TrackedPoint> found;
  if (frame.levels.empty()) return found;
  const double focal = std::abs(camera.fx);
  const Pose cam_from_world = world_from_cam.inverse();
  for (const int id : keyframes) {
    Keyframe& host = map.at(id);
    const Pose cam_from_host = cam_from_world * host.world_from_cam;
    std::vector<std::uint8_t> is_tracked(host.points.size(), 0);
    for (const PointRef& ref : tracked)
      if (ref.keyframe == id) is_tracked[ref.point] = 1;
    for (int i = 0; i < static_cast<int>(host.points.size()); ++i) {
      MapPoint& point = host.points[i];
      if (point.is_given_up || is_tracked[i] || point.is_known()) continue;
      auto segment = epipolar_segment(point, cam_from_host, shutter, camera);
      if (segment) segment = within(camera, *segment);
      if (!segment) continue;
      const auto warp = warp_of_patch(point.position(), cam_from_host, camera);
      if (!warp) continue;
      ++point.sought;
      const auto place = found_along(host, point, frame, *segment, *warp);
      const auto ray = place ? plane_ray(camera, place->pixel2) : std::nullopt;
      if (ray) {
        const double sigma_px = std::max(kNoisePx, place->noise_px.sigma);
        const Eigen::Vector3d at_middle = shutter.at_middle(*ray, row_of(camera, place->pixel2.y()));
        if (take_in(point, at_middle, sigma_px / focal, cam_from_host, kMaxErrorPx / focal)) {
          ++point.found;
          found.push_back({{id, i}, place->pixel2, *ray, place->noise_px});
        }
      }
      constexpr int kPatience = 4;
      point.is_given_up = point.sought - point.found >= kPatience && 2 * point.found < point.sought;
    }
  }
  return found;
}

}  // namespace framewise
