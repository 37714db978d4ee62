// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/view_pair.h"

namespace framewise {
namespace {

// Shares of the patches: what is found by chance, what will do where more vouches for the pose, and what
// needs none to vouch for it.
constexpr double kMoreThanChance = 0.33, kFewWillDo = 0.05, kHalf = 0.5;
// How many levels above their own patches are looked for from afar, and how many patches.
constexpr int kFar = 3, kFew = 150;

MapMatch match_of(const PointRef& ref, const Eigen::Vector3d& ray, double row, const PlaceNoise& noise_px,
                  const Shutter& shutter, const MapView& view) {
  const Keyframe& host = view.map.at(ref.keyframe);
  const MapPoint& point = host.points[ref.point];
  const Pose before_from_host = view.world_from_before.inverse() * host.world_from_cam;
  MapMatch match;
  match.X = before_from_host * point.position();
  match.S = before_from_host.R * point.covariance() * before_from_host.R.transpose();
  match.ray = shutter.at_middle(ray, row);
  match.noise = noise_px.at_least(view.options.map.least_sigma_px) / std::abs(view.camera.fx);
  match.z = std::numeric_limits<double>::quiet_NaN();
  return match;
}

// How the match follows the shutter's readout: the host's view of the point and this one are both skewed.
void set_skew(const PointRef& ref, const Eigen::Matrix3d& cam_from_before, double row, const Shutter& shutter,
              const MapView& view, MapMatch& match) {
  const Keyframe& host = view.map.at(ref.keyframe);
  const MapPoint& point = host.points[ref.point];
  const Eigen::Matrix3d cam_from_host =
      cam_from_before * view.world_from_before.R.transpose() * host.world_from_cam.R;
  const double host_row = row_of(view.camera, host.frame->pixel(point.feature).y());
  const Eigen::Vector3d by_host = cam_from_host * host.shutter.at_middle_by_readout(point.ray, host_row);
  const Eigen::Vector2d host_skew = (by_host - by_host.z() * match.ray).head<2>();
  const Eigen::Vector2d own_skew = shutter.at_middle_by_readout(match.ray, row).head<2>();
  match.by_readout = host_skew - own_skew;
  match.skew = std::max(host_skew.norm(), own_skew.norm());
}

// Where the depth image was taken, of a camera that turned until this frame as it turns while depth is late.
Pose depth_from_cam(const MapFrame& frame, const Pose& cam_from_before, const MapView& view) {
  const double dt = frame.time - view.time_before;
  const double share = view.options.map.follow && dt > 0 ? frame.depth_delay / dt : 0;
  return {so3_exp(share * so3_log(cam_from_before.R)), share * cam_from_before.t};
}

// A pose from matched features; matched: of how many, at most.
std::optional<FirstPose> find_first_pose(const MapFrame& frame, const Pose& predicted,
                                         const std::vector<int>& keyframes, const MapView& view,
                                         int& matched) {
  const MapOptions& map_options = view.options.map;
  const Pose predicted_from_before = predicted.inverse() * view.world_from_before;
  FirstPoseOptions options;
  options.max_error = 4 / std::abs(view.camera.fx);
  options.min_inliers = map_options.min_inliers;
  options.ransac = view.options.ransac;
  options.ransac.seed = view.options.seed + 0x9e3779b97f4a7c15ull * (frame.index + 1);
  const Shutter shutter = shutter_of(predicted_from_before, frame.time, view);
  const auto attempt = [&](const std::vector<FeatureOfPoint>& found) {
    std::vector<MapMatch> matches;
    for (const FeatureOfPoint& match : found)
      matches.push_back(match_of(match.ref, frame.rays[match.feature],
                                 row_of(view.camera, frame.pixel(match.feature).y()), {}, shutter, view));
    matched = std::max(matched, static_cast<int>(matches.size()));
    return first_pose(matches, predicted_from_before, options);
  };
  const auto visible = points_in_view(view.map, keyframes, predicted, view.camera, shutter);
  constexpr double kSettledPx = 4, kWider = 4;
  const auto known = settled(visible, kSettledPx);
  const auto near = match_in_window(view.map, known, frame, map_options.window_px);
  if (auto pose = attempt(near); pose && 3 * pose->inliers > static_cast<int>(near.size())) return pose;
  // Where the camera began or ended to turn since the frame before.
  const auto wide = match_in_window(view.map, known, frame, kWider * map_options.window_px);
  if (auto pose = attempt(wide); pose && pose->inliers > 2 * options.min_inliers) return pose;
  std::optional<FirstPose> best;
  for (auto id = keyframes.rbegin(); id != keyframes.rend(); ++id) {
    const auto pose = attempt(match_anywhere(view.map.at(*id), frame));
    if (pose && (!best || pose->inliers > best->inliers)) best = pose;
    if (best && best->inliers > 2 * options.min_inliers) break;
  }
  return best;
}

// All patches around where a pose has them, and again from the pose that they give while that is so far off
// the other that many may have been missed.
Placed look_nearby(const MapFrame& frame, Pose cam_from_before, const std::vector<int>& keyframes,
                   const MapView& view, double least_found = 0.2) {
  constexpr int kNearby = 0, kMostLooks = 3;
  const MapOptions& options = view.options.map;
  for (int look = 1;; ++look) {
    Placed placed = place_near(frame, cam_from_before, keyframes, kNearby, options.points, view);
    const Pose& found = placed.pose.cam_from_reference;
    if (!is_credible(placed, options, least_found) || look == kMostLooks) return placed;
    const double shift = shift_between(placed.matches, cam_from_before, found);
    if (shift * std::abs(view.camera.fx) < options.look_again_px) return placed;
    cam_from_before = found;
  }
}

// Features matched near the prediction and then anywhere, and patches from the pose that they give.
std::optional<Placed> place_by_features(MapFrame& frame, const Pose& predicted,
                                        const std::vector<int>& keyframes, const MapView& view) {
  const MapOptions& options = view.options.map;
  describe(frame, view.camera, options);
  int matched = 0;
  const auto first = find_first_pose(frame, predicted, keyframes, view, matched);
  // From here it is the features that vouch for the pose.
  if (!first || first->inliers < 2 * options.min_inliers) return std::nullopt;
  Placed placed = look_nearby(frame, first->cam_from_reference, keyframes, view, kFewWillDo);
  placed.matched = std::max(matched, placed.matched);
  placed.iterations = first->iterations;
  return is_credible(placed, options, kFewWillDo) ? std::optional(placed) : std::nullopt;
}

std::uint64_t seed_of_pair(const MapFrame& frame, const MapView& view) {
  return view.options.seed + 0xd1b54a32d192ed03ull * (frame.index + 1);
}

std::vector<int> seen_from(const Pose& world_from_cam, const MapView& view) {
  const MapOptions& options = view.options.map;
  return keyframes_in_view(view.map, world_from_cam, view.camera, options.newest, options.others);
}

std::vector<int> seen_from(const Placed& placed, const MapView& view) {
  return seen_from(view.world_from_before * placed.pose.cam_from_reference.inverse(), view);
}

// A pose from an earlier frame, as from the one before; without points of the map.
Placed as_placed(const MapPose& pair, const MapFrame& frame, const Pose& world_from_earlier,
                 const MapView& view) {
  Placed placed;
  placed.pose = pair;
  placed.pose.cam_from_reference =
      pair.cam_from_reference * world_from_earlier.inverse() * view.world_from_before;
  placed.pose.inliers.clear();
  placed.shutter = shutter_of(placed.pose.cam_from_reference, frame.time, view);
  placed.matched = static_cast<int>(pair.inliers.size());
  return placed;
}

}  // namespace

Shutter shutter_of(const Pose& cam_from_before, double time, const MapView& view) {
  return {view.options.map.unskew ? view.readout : 0,
          view.turns.rate(cam_from_before.R, view.world_from_before.R, view.time_before, time)};
}

double shown_noise_px(const Placed& placed, const MapOptions& options) {
  return placed.pose.ray_scale * options.least_sigma_px;
}

bool is_credible(const Placed& placed, const MapOptions& options, double least_found) {
  constexpr double kMostNoisePx = 1.5;
  const int found = static_cast<int>(placed.matches.size());
  return placed.pose.num_inliers >= options.min_inliers && 2 * placed.pose.num_inliers >= found &&
         found >= least_found * placed.sought && placed.pose.covariance.allFinite() &&
         shown_noise_px(placed, options) < kMostNoisePx;
}

bool explains_better(const Placed& one, const Placed& other) {
  const auto information = [](const MapPose& pose) {
    return pose.num_inliers / (pose.ray_scale * pose.ray_scale);
  };
  return information(one.pose) > information(other.pose);
}

Placed place_near(const MapFrame& frame, const Pose& cam_from_before, const std::vector<int>& keyframes,
                  int coarser, int max_points, const MapView& view) {
  Placed placed;
  placed.pose.cam_from_reference = cam_from_before;
  const Pose world_from_cam = view.world_from_before * cam_from_before.inverse();
  placed.shutter = shutter_of(cam_from_before, frame.time, view);
  constexpr double kSettledPx = 2;  // half of what patches find
  const auto visible =
      settled(points_in_view(view.map, keyframes, world_from_cam, view.camera, placed.shutter), kSettledPx);
  placed.points =
      track_map_points(view.map, visible, frame, world_from_cam, view.camera, coarser, max_points);
  placed.sought = std::min(max_points, static_cast<int>(visible.size()));
  placed.matched = static_cast<int>(placed.points.size());
  if (placed.matched < view.options.map.min_inliers) return placed;
  const Pose to_depth = depth_from_cam(frame, cam_from_before, view);
  for (const TrackedPoint& point : placed.points) {
    const double row = row_of(view.camera, point.pixel.y());
    MapMatch match = match_of(point.ref, point.ray, row, point.noise_px, placed.shutter, view);
    if (const auto plane = depth_along(frame, point.ray, to_depth, view.camera, view.options)) {
      match.z = placed.shutter.depth_at_middle(point.ray, row, plane->z);
      match.z_share = plane->noise_share;
    }
    set_skew(point.ref, cam_from_before.R, row, placed.shutter, view, match);
    placed.matches.push_back(match);
  }
  placed.pose = refine_map_pose(placed.matches, cam_from_before, view.options.depth_noise);
  return placed;
}

std::optional<Placed> place(MapFrame& frame, const Pose& predicted, const MapView& view,
                            std::optional<Placed>& unsure) {
  const MapOptions& options = view.options.map;
  const auto keyframes = keyframes_in_view(view.map, predicted, view.camera, options.newest, options.others);
  const Pose predicted_from_before = predicted.inverse() * view.world_from_before;
  Placed placed = place_near(frame, predicted_from_before, keyframes, kFar, kFew, view);
  // Few will do to say where to look for all, if many are found there: where a corridor repeats itself,
  // features find another part of it.
  const double least_found = is_credible(placed, options) ? kMoreThanChance : kHalf;
  if (is_credible(placed, options, kFewWillDo))
    placed = look_nearby(frame, placed.pose.cam_from_reference, keyframes, view);
  constexpr double kDoubtfulPx = 0.4, kMoreThanUsual = 1.5;  // blur, or a wrong pose
  const double doubtful = std::max(kDoubtfulPx, kMoreThanUsual * view.usual_noise_px);
  if (is_credible(placed, options, kHalf) && shown_noise_px(placed, options) < doubtful) return placed;
  const bool is_found = is_credible(placed, options, least_found);
  auto by_features = place_by_features(frame, predicted, keyframes, view);
  if (is_found) return by_features && explains_better(*by_features, placed) ? by_features : placed;
  if (is_credible(placed, options)) unsure = placed;
  return by_features;
}

std::optional<Placed> place_by_pair(const MapFrame& frame, FrameView& frame_view, FrameView& earlier,
                                    const Pose& world_from_earlier, const Pose& predicted,
                                    const MapView& view) {
  FramePairOptions options;
  options.odometry = view.options;
  options.odometry.ransac.seed = seed_of_pair(frame, view);
  const Pose prior = predicted.inverse() * world_from_earlier;
  const auto pair = pose_from_pair(earlier, frame_view, prior, view.camera, options);
  if (!pair) return std::nullopt;
  const Placed placed = as_placed(*pair, frame, world_from_earlier, view);
  const auto in_map =
      look_nearby(frame, placed.pose.cam_from_reference, seen_from(placed, view), view, kFewWillDo);
  return is_credible(in_map, view.options.map, kFewWillDo) ? in_map : placed;
}

std::optional<Placed> place_by_views(const MapFrame& frame, FrameView& frame_view, FrameView& earlier,
                                     const Pose& world_from_earlier, const Pose& predicted,
                                     const MapView& view) {
  const MapOptions& map_options = view.options.map;
  const auto known =
      earlier.frame().depth.empty()
          ? known_depths(view.map, seen_from(world_from_earlier, view), world_from_earlier, view.camera)
          : known_depths(earlier.described(view.camera), view.camera, view.options);
  RansacOptions ransac = view.options.ransac;
  ransac.seed = seed_of_pair(frame, view);
  const Pose prior = predicted.inverse() * world_from_earlier;
  const auto found = pose_from_views(earlier, frame_view, prior, known, view.camera, ransac);
  if (!found) return std::nullopt;
  const Placed placed = as_placed(found->pose, frame, world_from_earlier, view);
  const auto keyframes = seen_from(placed, view);
  Pose from = placed.pose.cam_from_reference;
  if (found->is_guess) {
    const Placed far = place_near(frame, from, keyframes, kFar, kFew, view);
    if (is_credible(far, map_options)) from = far.pose.cam_from_reference;
  }
  // Long ago the camera was elsewhere: features that hardly tell how far do not vouch for a place.
  const bool tells_too_little = found->is_far && earlier.frame().time < view.time_before;
  const double least_found = tells_too_little ? kMoreThanChance : kFewWillDo;
  const Placed in_map = look_nearby(frame, from, keyframes, view, least_found);
  if (is_credible(in_map, map_options, least_found)) return in_map;
  if (tells_too_little) return std::nullopt;
  if (!found->is_guess) return placed;
  if (earlier.frame().depth.empty()) return std::nullopt;
  Placed turned = placed;
  const Pose world_from_cam{view.world_from_before.R * placed.pose.cam_from_reference.R.transpose(),
                            predicted.t};
  turned.pose.cam_from_reference = world_from_cam.inverse() * view.world_from_before;
  turned.is_foretold = true;
  return turned;
}

std::vector<PlacedBy> placed_by(const Placed& placed, const DepthNoise& noise) {
  const Pose& cam_from_before = placed.pose.cam_from_reference;
  std::vector<PlacedBy> points;
  for (std::size_t i = 0; i < placed.matches.size(); ++i) {
    const MapMatch& match = placed.matches[i];
    if (!placed.pose.inliers[i]) continue;
    PlacedBy point;
    point.ref = placed.points[i].ref;
    point.x_in_cam = cam_from_before * match.X;
    point.S = cam_from_before.R * match.S * cam_from_before.R.transpose();
    point.ray_residual = point.x_in_cam.head<2>() / point.x_in_cam.z() - match.ray.head<2>();
    point.ray_noise = match.noise * placed.pose.ray_scale;
    if (match.z > 0) {
      const double sigma = placed.pose.depth_scale * match.z_share * noise.sigma(match.z);
      point.z_residual = point.x_in_cam.z() - match.z;
      if (std::abs(point.z_residual) < 3 * std::hypot(sigma, std::sqrt(point.S(2, 2)))) point.z_sigma = sigma;
    }
    points.push_back(point);
  }
  return points;
}

Correspondences seen_from_before(const Placed& placed, const Camera& camera) {
  Correspondences seen;
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const MapMatch& match = placed.matches[i];
    seen.pixels1.push_back(camera.project(match.X).value_or(placed.points[i].pixel));
    seen.pixels2.push_back(placed.points[i].pixel);
    seen.x1.push_back(match.X.normalized());
    seen.x2.push_back(match.ray.normalized());
    seen.z1.push_back(match.X.z());
    seen.z2.push_back(match.z);
    seen.sigma1.push_back(match.noise.sigma);
    seen.sigma2.push_back(match.noise.sigma);
    seen.distance.push_back(0);
  }
  return seen;
}

}  // namespace framewise
