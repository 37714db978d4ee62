// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/two_view_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "framewise/geometry/triangulation.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {
namespace {

std::vector<int> all_features(const MapFrame& frame) {
  std::vector<int> all(frame.rays.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<double> parallaxes(const Eigen::Matrix3d& R, const std::vector<Eigen::Vector3d>& x1,
                               const std::vector<Eigen::Vector3d>& x2,
                               const std::vector<std::uint8_t>& inliers) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < x1.size(); ++i)
    if (inliers[i]) angles.push_back(parallax(R, x1[i], x2[i]));
  return angles;
}

}  // namespace

bool shows_motion(const std::vector<double>& angles, double direction_variance,
                  const TwoViewOptions& options) {
  const double least = options.min_parallax_deg * M_PI / 180;
  const auto showing = static_cast<int>(
      std::count_if(angles.begin(), angles.end(), [&](double angle) { return angle >= least; }));
  const double sure = options.sure_direction_deg * M_PI / 180;
  return 2 * showing >= static_cast<int>(angles.size()) ||
         (showing >= options.min_points && direction_variance <= sure * sure);
}

TwoViewStart start_from_two_views(const MapFrame& frame1, const MapFrame& frame2, const Camera& camera,
                                  const TwoViewOptions& options) {
  TwoViewStart start;
  if (frame1.levels.empty() || frame2.levels.empty()) return start;
  std::vector<cv::Point2f> unmoved;
  for (const cv::KeyPoint& keypoint : frame1.features.keypoints) unmoved.push_back(keypoint.pt);
  const auto pairs = pair_features(frame1, all_features(frame1), unmoved, frame2, all_features(frame2),
                                   camera, options.farthest * camera.width);
  start.pairs = static_cast<int>(pairs.size());
  if (start.pairs < options.min_pairs) return start;
  std::vector<Eigen::Vector3d> x1, x2;
  for (const FeaturePair& pair : pairs) {
    x1.push_back(frame1.rays[pair.feature1].normalized());
    x2.push_back(pair.ray2.normalized());
  }
  const double focal = std::abs(camera.fx);
  RelativePoseOptions relative;
  relative.ransac = options.ransac;
  relative.max_error = relative.refinement_error = options.max_error_px / focal;
  relative.min_inliers = options.min_pairs;
  const auto estimate = estimate_relative_pose(x1, x2, relative);
  if (!estimate) return start;
  start.cam2_from_cam1 = estimate->cam2_from_cam1;
  start.support = estimate->kind;
  start.covariance = estimate->covariance;
  start.inliers = static_cast<int>(estimate->num_inliers);
  start.iterations = estimate->iterations;
  start.kind = TwoViewStart::Kind::kTurned;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (estimate->inliers[i]) start.agreeing.push_back(pairs[i]);
  if (estimate->kind != EstimateKind::kFull) return start;
  const double direction_variance = estimate->covariance.bottomRightCorner<3, 3>().trace();
  if (!shows_motion(parallaxes(estimate->cam2_from_cam1.R, x1, x2, estimate->inliers), direction_variance,
                    options))
    return start;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!estimate->inliers[i]) continue;
    auto point =
        triangulated_point(frame1.rays[pairs[i].feature1], pairs[i], estimate->cam2_from_cam1, focal, {});
    if (!point) continue;
    start.points.push_back(std::move(*point));
    start.seen_by.push_back(pairs[i]);
  }
  if (static_cast<int>(start.points.size()) >= options.min_points) {
    start.kind = TwoViewStart::Kind::kTriangulated;
  } else {
    start.points.clear(), start.seen_by.clear();
  }
  return start;
}

std::optional<double> length_by_depth(const TwoViewStart& two_views, const MapFrame& frame2,
                                      const Camera& camera, const OdometryOptions& options) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < two_views.points.size(); ++i) {
    const double unit_z = (two_views.cam2_from_cam1 * two_views.points[i].position()).z();
    const auto plane = depth_along(frame2, two_views.seen_by[i].ray2, {}, camera, options);
    if (plane && unit_z > 0) lengths.push_back(plane->z / unit_z);
  }
  constexpr std::size_t kFewest = 10;  // half of which may be of other surfaces
  if (lengths.size() < kFewest) return std::nullopt;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

SeenByBoth add_two_views(LocalMap& map, std::shared_ptr<const MapFrame> frame2, const TwoViewStart& two_views,
                         double length, const Camera& camera, const MapOptions& options) {
  const int host_id = map.newest_id();
  Pose cam2_from_cam1 = two_views.cam2_from_cam1;
  cam2_from_cam1.t *= length;
  const int viewer_id =
      map.add(std::move(frame2), map.at(host_id).world_from_cam * cam2_from_cam1.inverse()).id;
  Keyframe& host = map.at(host_id);
  SeenByBoth seen;
  for (std::size_t i = 0; i < two_views.points.size(); ++i) {
    MapPoint point = two_views.points[i];
    point.inverse_z /= length;
    point.variance /= length * length;
    const FeaturePair& pair = two_views.seen_by[i];
    const PlaceNoise noise = pair.noise_px.at_least(options.least_sigma_px) / std::abs(camera.fx);
    point.views.push_back({viewer_id, pair.ray2, noise, std::numeric_limits<double>::quiet_NaN(), pair.ray2,
                           row_of(camera, pair.pixel2.y())});
    const PointRef ref{host_id, static_cast<int>(host.points.size())};
    host.points.push_back(std::move(point));
    seen.by_first.push_back({ref, host.frame->pixel(pair.feature1), host.frame->rays[pair.feature1], {}});
    seen.by_second.push_back({ref, pair.pixel2, pair.ray2, pair.noise_px});
  }
  return seen;
}

}  // namespace framewise
