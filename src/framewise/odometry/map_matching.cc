// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_matching.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "framewise/features/matching.h"
#include "framewise/features/windowed_matching.h"

namespace framewise {
namespace {

std::vector<cv::Point2f> places_of(const Features& features) {
  std::vector<cv::Point2f> pixels;
  for (const cv::KeyPoint& keypoint : features.keypoints) pixels.push_back(keypoint.pt);
  return pixels;
}

cv::Mat rows_for(int count, const cv::Mat& like) { return cv::Mat(count, like.cols, like.type()); }

// Points of as many parts of the image as there are, at most `max_count`: one of each cell, then another.
// Within a cell points of known depth come first, and newer keyframes, whose view is more alike.
std::vector<int> spread_over_image(const std::vector<VisiblePoint>& points, int max_count) {
  constexpr double kCellPx = 32;
  std::vector<int> order;
  if (static_cast<int>(points.size()) <= max_count) {
    for (int i = 0; i < static_cast<int>(points.size()); ++i) order.push_back(i);
    return order;
  }
  int columns = 1;
  for (const VisiblePoint& point : points)
    columns = std::max(columns, static_cast<int>(point.pixel.x() / kCellPx) + 2);
  std::vector<std::pair<int, int>> ranked;  // rank in its cell, index
  std::vector<int> taken;
  for (const bool known : {true, false})
    for (int i = static_cast<int>(points.size()) - 1; i >= 0; --i) {
      if ((points[i].spread_px == 0) != known) continue;
      const auto cell =
          static_cast<std::size_t>(static_cast<int>(std::max(0.0, points[i].pixel.y()) / kCellPx) * columns +
                                   static_cast<int>(std::max(0.0, points[i].pixel.x()) / kCellPx));
      if (cell >= taken.size()) taken.resize(cell + 1, 0);
      ranked.emplace_back(taken[cell]++, i);
    }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  ranked.resize(max_count);
  for (const auto& [rank, index] : ranked) order.push_back(index);
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace

int level_of(const Keyframe& host, const MapPoint& point, const Eigen::Matrix2d& warp, int levels) {
  const double scale = host.frame->features.scale(point.feature) * std::sqrt(std::abs(warp.determinant()));
  return std::clamp(static_cast<int>(std::lround(std::log2(std::max(1e-3, scale)))), 0, levels - 1);
}

std::optional<TrackedPatch> track_from_coarse(const ImageLevels& host, const ImageLevels& frame,
                                              PatchWarp warp, int coarser) {
  const int finest = warp.level;
  PatchTrackOptions coarse;
  coarse.min_correlation = 0.6;  // only to begin the next level from
  coarse.measures_noise = false;
  for (int level = std::min(finest + coarser, static_cast<int>(frame.size()) - 1); level > finest; --level) {
    warp.level = level;
    if (const auto found = track_patch(host, frame, warp, coarse)) warp.pixel2 = found->pixel2;
  }
  warp.level = finest;
  return track_patch(host, frame, warp);
}

std::vector<FeatureOfPoint> match_in_window(const LocalMap& map, const std::vector<VisiblePoint>& points,
                                            const MapFrame& frame, double window_px) {
  if (points.empty() || frame.features.keypoints.empty()) return {};
  cv::Mat descriptors = rows_for(static_cast<int>(points.size()), frame.features.descriptors);
  std::vector<cv::Point2f> expected;
  for (int i = 0; i < descriptors.rows; ++i) {
    const PointRef& ref = points[i].ref;
    map.at(ref.keyframe).frame->features.descriptors.row(map.point(ref).feature).copyTo(descriptors.row(i));
    expected.emplace_back(static_cast<float>(points[i].pixel.x()), static_cast<float>(points[i].pixel.y()));
  }
  MatchOptions options;
  options.window_px = window_px;
  options.max_ratio = 0.95;
  std::vector<FeatureOfPoint> matches;
  for (const FeatureMatch& match : match_windowed(descriptors, expected, frame.features.descriptors,
                                                  places_of(frame.features), options)) {
    constexpr float kMaxBits = 80;  // of 256: unrelated descriptors seldom are so near
    if (match.distance <= kMaxBits) matches.push_back({points[match.index1].ref, match.index2});
  }
  return matches;
}

std::vector<FeatureOfPoint> match_anywhere(const Keyframe& keyframe, const MapFrame& frame) {
  if (keyframe.points.empty() || frame.features.keypoints.empty()) return {};
  const cv::Mat& of_host = keyframe.frame->features.descriptors;
  cv::Mat descriptors = rows_for(static_cast<int>(keyframe.points.size()), of_host);
  for (int i = 0; i < descriptors.rows; ++i)
    of_host.row(keyframe.points[i].feature).copyTo(descriptors.row(i));
  MatchOptions options;
  options.max_ratio = 0.85;
  std::vector<FeatureOfPoint> matches;
  for (const FeatureMatch& match : match_features(descriptors, frame.features.descriptors, options))
    if (keyframe.points[match.index1].is_known() && !keyframe.points[match.index1].is_given_up)
      matches.push_back({{keyframe.id, match.index1}, match.index2});
  return matches;
}

std::optional<Eigen::Matrix2d> warp_of_patch(const Eigen::Vector3d& x_in_host, const Pose& cam_from_host,
                                             const Camera& camera, const Eigen::Vector2d& slope) {
  const auto in_host = camera.project_jacobian(x_in_host);
  const auto in_cam = camera.project_jacobian(cam_from_host * x_in_host);
  if (!in_host || !in_cam) return std::nullopt;
  Eigen::Matrix<double, 3, 2> along = Eigen::Matrix<double, 3, 2>::Zero();
  along.topRows<2>().setIdentity();
  along -= x_in_host * slope.transpose();
  return *in_cam * cam_from_host.R * along * in_host->leftCols<2>().inverse();
}

std::vector<TrackedPoint> track_map_points(const LocalMap& map, const std::vector<VisiblePoint>& points,
                                           const MapFrame& frame, const Pose& world_from_cam,
                                           const Camera& camera, int coarser, int max_count) {
  std::vector<TrackedPoint> tracked;
  if (frame.levels.empty()) return tracked;
  const Pose cam_from_world = world_from_cam.inverse();
  const int levels = static_cast<int>(frame.levels.size());
  for (const int i : spread_over_image(points, max_count)) {
    const VisiblePoint& visible = points[i];
    const Keyframe& host = map.at(visible.ref.keyframe);
    const MapPoint& point = host.points[visible.ref.point];
    const auto warp =
        warp_of_patch(point.position(), cam_from_world * host.world_from_cam, camera, point.slope);
    if (!warp) continue;
    const auto found = track_from_coarse(
        host.frame->levels, frame.levels,
        {host.frame->pixel(point.feature), visible.pixel, *warp, level_of(host, point, *warp, levels)},
        coarser);
    if (!found) continue;
    if (const auto ray = plane_ray(camera, found->pixel2))
      tracked.push_back({visible.ref, found->pixel2, *ray, found->noise_px});
  }
  return tracked;
}

}  // namespace framewise
