// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/frame_pair.h"

#include <cmath>
#include <limits>

#include "framewise/features/matching.h"

namespace framewise {
namespace {

std::vector<MapMatch> match_points(const MapFrame& first, const MapFrame& second, const Camera& camera,
                                   const FramePairOptions& options) {
  std::vector<MapMatch> matches;
  const double focal = std::abs(camera.fx);
  for (const FeatureMatch& match :
       match_brute_force(first.features.descriptors, second.features.descriptors)) {
    const Eigen::Vector3d& ray1 = first.rays[match.index1];
    const auto plane1 = depth_along(first, ray1, Pose(), camera, options.odometry);
    if (!plane1) continue;
    const double sigma1 = options.sigma_px * first.features.scale(match.index1) / focal;
    MapMatch point;
    point.X = point_at_depth(ray1, plane1->z);
    point.S = point_covariance(ray1, plane1->z, sigma1,
                               plane1->noise_share * options.odometry.depth_noise.sigma(plane1->z));
    point.ray = second.rays[match.index2];
    point.noise.sigma = options.sigma_px * second.features.scale(match.index2) / focal;
    point.z = std::numeric_limits<double>::quiet_NaN();
    if (const auto plane2 = depth_along(second, point.ray, Pose(), camera, options.odometry))
      point.z = plane2->z, point.z_share = plane2->noise_share;
    matches.push_back(point);
  }
  return matches;
}

}  // namespace

FrameView::FrameView(const MapFrame& frame) {
  frame_.index = frame.index;
  frame_.time = frame.time;
  frame_.levels = frame.levels;
  frame_.depth = frame.depth;
  frame_.has_depth = frame.has_depth;
  frame_.depth_delay = frame.depth_delay;
}

const MapFrame& FrameView::described(const Camera& camera) {
  MapOptions options;
  options.features = 3000;  // blur and ghosts make most of them useless
  options.spread = "none";
  describe(frame_, camera, options);
  return frame_;
}

std::optional<MapPose> pose_from_pair(FrameView& first, FrameView& second, const Pose& prior,
                                      const Camera& camera, const FramePairOptions& options) {
  if (first.empty() || second.empty() || first.frame().depth.empty()) return std::nullopt;
  const auto matches = match_points(first.described(camera), second.described(camera), camera, options);
  FirstPoseOptions first_options;
  first_options.max_error = options.max_error_px / std::abs(camera.fx);
  first_options.min_inliers = options.min_inliers;
  first_options.ransac = options.odometry.ransac;
  const auto found = first_pose(matches, prior, first_options);
  if (!found) return std::nullopt;
  std::vector<MapMatch> agreeing;
  for (const MapMatch& match : matches)
    if (agrees(match, found->cam_from_reference, first_options.max_error)) agreeing.push_back(match);
  MapPose pose = refine_map_pose(agreeing, found->cam_from_reference, options.odometry.depth_noise);
  const bool holds = pose.num_inliers >= options.min_inliers && pose.covariance.allFinite();
  return holds ? std::optional(std::move(pose)) : std::nullopt;
}

}  // namespace framewise
