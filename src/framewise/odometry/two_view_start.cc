// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/two_view_start.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "framewise/geometry/triangulation.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {
namespace {

// The share of an image's width that a feature may move between the first two views.
constexpr double kFarthest = 0.25;

std::vector<int> all_features(const MapFrame& frame) {
  std::vector<int> all(frame.rays.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

double median_parallax(const Eigen::Matrix3d& R, const std::vector<Eigen::Vector3d>& x1,
                       const std::vector<Eigen::Vector3d>& x2, const std::vector<std::uint8_t>& inliers) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < x1.size(); ++i)
    if (inliers[i]) angles.push_back(parallax(R, x1[i], x2[i]));
  if (angles.empty()) return 0;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  return *middle;
}

}  // namespace

TwoViewStart start_from_two_views(const MapFrame& frame1, const MapFrame& frame2, const Camera& camera,
                                  const TwoViewOptions& options) {
  TwoViewStart start;
  if (frame1.levels.empty() || frame2.levels.empty()) return start;
  std::vector<cv::Point2f> unmoved;
  for (const cv::KeyPoint& keypoint : frame1.features.keypoints) unmoved.push_back(keypoint.pt);
  const auto pairs = pair_features(frame1, all_features(frame1), unmoved, frame2, all_features(frame2),
                                   camera, kFarthest * camera.width);
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
  start.inliers = static_cast<int>(estimate->num_inliers);
  start.iterations = estimate->iterations;
  start.kind = TwoViewStart::Kind::kTurned;
  if (estimate->kind != EstimateKind::kFull) return start;
  const double angle = median_parallax(estimate->cam2_from_cam1.R, x1, x2, estimate->inliers);
  if (angle < options.min_parallax_deg * M_PI / 180) return start;
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

}  // namespace framewise
