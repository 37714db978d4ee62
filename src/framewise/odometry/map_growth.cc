// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/features/matching.h"
#include "framewise/features/windowed_matching.h"
#include "framewise/geometry/triangulation.h"
#include "framewise/odometry/taken_places.h"

namespace framewise {
namespace {

cv::Mat listed_rows(const cv::Mat& all, const std::vector<int>& listed) {
  cv::Mat rows(static_cast<int>(listed.size()), all.cols, all.type());
  for (int i = 0; i < rows.rows; ++i) all.row(listed[i]).copyTo(rows.row(i));
  return rows;
}

std::vector<Eigen::Vector2d> places_taken(const LocalMap& map, int id, const Camera& camera) {
  std::vector<Eigen::Vector2d> taken;
  for (const MapPoint& point : map.at(id).points) taken.push_back(map.at(id).frame->pixel(point.feature));
  for (int host = map.first_id(); host <= map.newest_id(); ++host)
    for (const MapPoint& point : map.at(host).points)
      for (const PointView& view : point.views)
        if (view.keyframe == id)
          if (const auto pixel = camera.project(view.seen)) taken.push_back(*pixel);
  return taken;
}

double median_inverse_z(const Keyframe& keyframe) {
  std::vector<double> values;
  for (const MapPoint& point : keyframe.points) values.push_back(point.inverse_z);
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<int> open_features(const MapFrame& frame, const std::vector<Eigen::Vector2d>& taken,
                               double apart_px) {
  if (frame.levels.empty()) return {};
  TakenPlaces places(frame.levels[0].size(), apart_px);
  for (const Eigen::Vector2d& pixel : taken) places.take(pixel);
  std::vector<int> open;
  for (int i = 0; i < static_cast<int>(frame.rays.size()); ++i)
    if (places.is_free(frame.pixel(i))) open.push_back(i);
  return open;
}

std::vector<FeaturePair> pair_features(const MapFrame& frame1, const std::vector<int>& features1,
                                       const std::vector<cv::Point2f>& expected2, const MapFrame& frame2,
                                       const std::vector<int>& features2, const Camera& camera,
                                       double window_px) {
  if (features1.empty() || features2.empty()) return {};
  std::vector<cv::Point2f> pixels2;
  for (const int i : features2) pixels2.push_back(frame2.features.keypoints[i].pt);
  MatchOptions options;
  options.window_px = window_px;
  options.max_ratio = 0.85;
  const auto matches = match_windowed(listed_rows(frame1.features.descriptors, features1), expected2,
                                      listed_rows(frame2.features.descriptors, features2), pixels2, options);
  std::vector<FeaturePair> pairs;
  for (const FeatureMatch& match : matches) {
    constexpr float kMaxBits = 64;
    if (match.distance > kMaxBits) continue;
    const int i = features1[match.index1], j = features2[match.index2];
    const double scale = frame1.features.scale(i);
    const int level = std::clamp(static_cast<int>(std::lround(std::log2(scale))), 0,
                                 static_cast<int>(frame2.levels.size()) - 1);
    const double growth = frame2.features.scale(j) / scale;
    const auto found =
        track_patch(frame1.levels, frame2.levels,
                    {frame1.pixel(i), frame2.pixel(j), growth * Eigen::Matrix2d::Identity(), level});
    if (!found) continue;
    if (const auto ray = plane_ray(camera, found->pixel2))
      pairs.push_back({i, j, found->pixel2, *ray, found->noise_px});
  }
  return pairs;
}

std::optional<MapPoint> triangulated_point(const Eigen::Vector3d& ray1, const FeaturePair& pair,
                                           const Pose& cam2_from_cam1, double focal,
                                           const GrowthOptions& options) {
  const auto point = triangulate_midpoint(cam2_from_cam1, ray1, pair.ray2);
  if (!point || !point->in_front() || !(point->X1.z() > 0)) return std::nullopt;
  const double inverse_z = ray1.z() / point->X1.z();
  const Eigen::Vector3d X2 = cam2_from_cam1 * (ray1 / inverse_z);
  if (X2.z() <= 0) return std::nullopt;
  const double error = (X2.head<2>() / X2.z() - pair.ray2.head<2>()).norm();
  if (error * focal > options.max_error_px) return std::nullopt;
  // How the place in camera 2 follows the inverse depth.
  const Eigen::Vector3d dX = -(cam2_from_cam1.R * ray1) / (inverse_z * inverse_z);
  const Eigen::Vector2d d = (dX.head<2>() - X2.head<2>() / X2.z() * dX.z()) / X2.z();
  const Eigen::Matrix2d W = pair.noise_px.at_least(options.least_sigma_px).whitening() * focal;
  const double variance = 1 / (W * d).squaredNorm();
  if (!(std::sqrt(variance) < options.max_relative_sigma * inverse_z)) return std::nullopt;
  MapPoint made{pair.feature1, ray1, inverse_z, variance, 0, 0, {}, 0, 0};
  return made;
}

int grow_map(LocalMap& map, int older, int newer, const Camera& camera, const GrowthOptions& options) {
  Keyframe& host = map.at(older);
  const Keyframe& viewer = map.at(newer);
  constexpr double kApartPx = 6;
  const auto open1 = open_features(*host.frame, places_taken(map, older, camera), kApartPx);
  const auto open2 = open_features(*viewer.frame, places_taken(map, newer, camera), kApartPx);
  const Pose viewer_from_host = viewer.world_from_cam.inverse() * host.world_from_cam;
  const double inverse_z = median_inverse_z(host);
  std::vector<cv::Point2f> expected;
  for (const int i : open1) {
    const auto pixel =
        camera.project(viewer_from_host.R * host.frame->rays[i] + inverse_z * viewer_from_host.t);
    constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
    expected.push_back(pixel ? cv::Point2f(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()))
                             : cv::Point2f(kNowhere, kNowhere));
  }
  constexpr double kWindowPx = 60;
  const double focal = std::abs(camera.fx);
  int added = 0;
  auto pairs = pair_features(*host.frame, open1, expected, *viewer.frame, open2, camera, kWindowPx);
  for (FeaturePair& pair : pairs) {
    const double row1 = row_of(camera, host.frame->pixel(pair.feature1).y());
    const double row2 = row_of(camera, pair.pixel2.y());
    const Eigen::Vector3d seen2 = pair.ray2;
    pair.ray2 = viewer.shutter.at_middle(seen2, row2);
    auto point = triangulated_point(host.shutter.at_middle(host.frame->rays[pair.feature1], row1), pair,
                                    viewer_from_host, focal, options);
    if (!point) continue;
    const PlaceNoise noise = pair.noise_px.at_least(options.least_sigma_px) / focal;
    point->views.push_back({newer, pair.ray2, noise, std::numeric_limits<double>::quiet_NaN(), seen2, row2});
    host.points.push_back(std::move(*point));
    ++added;
  }
  return added;
}

}  // namespace framewise
