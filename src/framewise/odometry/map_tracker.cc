// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/depth_filter.h"
#include "framewise/odometry/map_growth.h"
#include "framewise/odometry/pose_estimate.h"
#include "framewise/odometry/window_adjustment.h"

namespace framewise {
namespace {

constexpr double kLensShare = 0.02;  // of what a window says of the lens (learn_lens)
constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

// Of cam2_from_cam1's tangent: what a camera 2 that is at fault by so much is told to be, in its own axes.
Matrix6d in_own_axes(const Matrix6d& covariance, const Pose& cam2_from_cam1) {
  Matrix6d J = Matrix6d::Identity();
  J.topLeftCorner<3, 3>() = cam2_from_cam1.R;
  J.bottomLeftCorner<3, 3>() = skew(cam2_from_cam1.t) * cam2_from_cam1.R;
  return J * covariance * J.transpose();
}

// Of the camera's orientation (its own axes) and position (the world's) from that of cam2_from_cam1.
Matrix6d of_placed_camera(const Matrix6d& covariance, const Pose& cam2_from_cam1,
                          const Eigen::Matrix3d& world_from_cam1) {
  Matrix6d J = Matrix6d::Zero();
  const Eigen::Matrix3d back = cam2_from_cam1.R.transpose();
  J.topLeftCorner<3, 3>() = cam2_from_cam1.R;
  J.bottomLeftCorner<3, 3>() = world_from_cam1 * skew(back * cam2_from_cam1.t);
  J.bottomRightCorner<3, 3>() = world_from_cam1 * back;
  return J * covariance * J.transpose();
}

}  // namespace

MapTracker::MapTracker(const Camera& camera, const OdometryOptions& options, PriorKnowledge known)
    : camera_(camera),
      options_(options),
      known_(std::move(known)),
      map_(options.map.keyframes),
      motion_(options.map.shrink) {}

MapTrack MapTracker::add(std::shared_ptr<MapFrame> frame) {
  if (map_.empty()) return start(std::move(frame));
  if (!has_points_) return start_without_depth(std::move(frame));
  auto placed = place(*frame, motion_.predict(frame->time));
  const bool was_missed = time_before_ > time_measured_;
  if (!placed && was_missed) placed = place(*frame, steady_.predict(frame->time));
  return placed ? measured(std::move(frame), *placed) : missed(std::move(frame));
}

MapTrack MapTracker::start(std::shared_ptr<MapFrame> frame) {
  MapTrack track;
  track.step.status = Status::kOk;
  track.step.covariance.setZero();
  motion_.start(frame->time, {});
  time_before_ = time_measured_ = frame->time;
  become_keyframe(frame, {}, nullptr);
  remember(*frame, {});
  return track;
}

// Until a motion is seen that tells how far things are, the camera turns where it is.
MapTrack MapTracker::start_without_depth(std::shared_ptr<MapFrame> frame) {
  MapTrack track;
  describe(*frame, camera_, options_.map);
  TwoViewOptions options;
  options.ransac = options_.ransac;
  options.ransac.seed = options_.seed + frame->index;
  const Keyframe& first = map_.newest();
  TwoViewStart two_views = start_from_two_views(*first.frame, *frame, camera_, options);
  track.step.matches = two_views.pairs;
  track.step.inliers = two_views.inliers;
  track.step.iterations = two_views.iterations;
  track.world_from_cam = world_from_before_;
  if (two_views.kind == TwoViewStart::Kind::kTriangulated) {
    build_from_two_views(frame, two_views);
    track.step.status = Status::kOk;
    track.world_from_cam = map_.newest().world_from_cam;
  } else if (two_views.kind == TwoViewStart::Kind::kTurned) {
    track.step.status = Status::kRotationOnly;
    track.world_from_cam = {first.world_from_cam.R * two_views.cam2_from_cam1.R.transpose(),
                            first.world_from_cam.t};
  }
  track.step.cam2_from_cam1 = track.world_from_cam.inverse() * world_from_before_;
  world_from_before_ = track.world_from_cam;
  covariance_before_.setZero();
  motion_.start(frame->time, track.world_from_cam);
  time_before_ = time_measured_ = frame->time;
  // Before they have too little in common to tell a turn.
  const bool sees_little = two_views.inliers < 3 * options.min_pairs;
  if (!has_points_ && sees_little) {
    become_keyframe(frame, track.world_from_cam, nullptr);
    waiting_.clear();
  }
  constexpr std::size_t kMostWaiting = 64;  // images that are kept
  remember(*frame, track.world_from_cam);
  if (has_points_) {
    place_waiting();
  } else if (waiting_.size() < kMostWaiting) {
    waiting_.push_back({trajectory_.size() - 1, frame});
  }
  return track;
}

// Frames that came before there was a map, as it has them: for the final poses.
void MapTracker::place_waiting() {
  const int newest = map_.newest_id(), first = newest - 1;
  const Pose world_from_first = map_.at(first).world_from_cam;
  const double start = map_.at(first).frame->time, seconds = map_.at(newest).frame->time - start;
  for (const auto& [index, frame] : waiting_) {
    const double share = seconds > 0 ? std::clamp((frame->time - start) / seconds, 0.0, 1.0) : 0;
    const Anchored& turned = trajectory_[index];
    Pose guess = map_.last_pose_of(turned.keyframe) * turned.keyframe_from_cam;
    guess.t = world_from_first.t + share * (map_.newest().world_from_cam.t - world_from_first.t);
    const Placed placed =
        refine(*frame, guess.inverse() * world_from_before_, {first, newest}, 2, options_.map.points);
    if (!is_credible(placed)) continue;
    const Pose world_from_cam = world_from_before_ * placed.pose.cam_from_reference.inverse();
    trajectory_[index] = {first, world_from_first.inverse() * world_from_cam};
  }
  waiting_.clear();
}

// A new part of the map goes on as fast as the last one ended.
double MapTracker::first_length(const MapFrame& frame1, const MapFrame& frame2) const {
  if (const double length = speed_ * (frame2.time - frame1.time); length > 0) return length;
  if (options_.scale != "truth" || !known_.truth) return 1;
  const auto pose1 = known_.truth(frame1.index), pose2 = known_.truth(frame2.index);
  const double length = pose1 && pose2 ? (pose2->t - pose1->t).norm() : 0;
  return length > 0 ? length : 1;
}

void MapTracker::build_from_two_views(std::shared_ptr<MapFrame> frame, TwoViewStart& two_views) {
  Keyframe& host = map_.at(map_.newest_id());
  const double length = first_length(*host.frame, *frame), focal = std::abs(camera_.fx);
  Pose cam2_from_cam1 = two_views.cam2_from_cam1;
  cam2_from_cam1.t *= length;
  const int host_id = host.id;
  const Pose world_from_cam = host.world_from_cam * cam2_from_cam1.inverse();
  Keyframe& viewer = map_.add(std::move(frame), world_from_cam);
  Keyframe& kept_host = map_.at(host_id);
  for (std::size_t i = 0; i < two_views.points.size(); ++i) {
    MapPoint point = std::move(two_views.points[i]);
    point.inverse_z /= length;
    point.variance /= length * length;
    const FeaturePair& pair = two_views.seen_by[i];
    point.views.push_back({viewer.id, pair.ray2, std::max(options_.map.least_sigma_px, pair.sigma_px) / focal,
                           kUnmeasured, pair.ray2, row_of(camera_, pair.pixel2.y())});
    kept_host.points.push_back(std::move(point));
  }
  has_points_ = true;
  points_at_keyframe_ = std::min(options_.map.points, static_cast<int>(kept_host.points.size()));
  world_from_before_ = world_from_cam;
  adjust();
  std::vector<TrackedPoint> seen1, seen2;
  for (std::size_t i = 0; i < two_views.seen_by.size(); ++i) {
    const FeaturePair& pair = two_views.seen_by[i];
    const PointRef ref{host_id, static_cast<int>(i)};
    seen1.push_back({ref, kept_host.frame->pixel(pair.feature1), kept_host.frame->rays[pair.feature1], 1});
    seen2.push_back({ref, pair.pixel2, pair.ray2, pair.sigma_px});
  }
  guess_points(kept_host, seen1);
  guess_points(map_.at(map_.newest_id()), seen2);
}

// Patches are looked for where the motion before foretells them, a few from afar and then all; where that
// fails, features are matched, near and then anywhere.
std::optional<MapTracker::Placed> MapTracker::place(MapFrame& frame, const Pose& predicted) const {
  const auto keyframes =
      keyframes_in_view(map_, predicted, camera_, options_.map.newest, options_.map.others);
  const Pose predicted_from_before = predicted.inverse() * world_from_before_;
  constexpr int kFar = 3, kFew = 150;
  const Placed from_afar = refine(frame, predicted_from_before, keyframes, kFar, kFew);
  if (is_credible(from_afar))
    if (auto placed = look_nearby(frame, from_afar.pose.cam_from_reference, keyframes)) return placed;

  describe(frame, camera_, options_.map);
  int matched = 0;
  const auto first = find_first_pose(frame, predicted, keyframes, matched);
  if (!first) return std::nullopt;
  auto placed = look_nearby(frame, first->cam_from_reference, keyframes);
  if (!placed) return std::nullopt;
  placed->matched = std::max(matched, placed->matched);
  placed->iterations = first->iterations;
  return placed;
}

// All patches around where a pose has them, and again from the pose that they give while that is so far off
// the other that many may have been missed.
std::optional<MapTracker::Placed> MapTracker::look_nearby(const MapFrame& frame, Pose cam_from_before,
                                                          const std::vector<int>& keyframes) const {
  constexpr int kNearby = 0, kMostLooks = 3;
  for (int look = 1;; ++look) {
    Placed placed = refine(frame, cam_from_before, keyframes, kNearby, options_.map.points);
    if (!is_credible(placed)) return std::nullopt;
    const Pose& found = placed.pose.cam_from_reference;
    const double shift_px = shift_between(placed.matches, cam_from_before, found) * std::abs(camera_.fx);
    if (shift_px < options_.map.look_again_px || look == kMostLooks) return placed;
    cam_from_before = found;
  }
}

// Most of what is found agrees, to the noise of a place that is found at all.
bool MapTracker::is_credible(const Placed& placed) const {
  constexpr double kMostNoisePx = 1.5, kLeastFound = 0.2;
  const int found = static_cast<int>(placed.matches.size());
  return placed.pose.num_inliers >= options_.map.min_inliers && 2 * placed.pose.num_inliers >= found &&
         found >= kLeastFound * placed.sought && placed.pose.covariance.allFinite() &&
         placed.pose.ray_scale * options_.map.least_sigma_px < kMostNoisePx;
}

Shutter MapTracker::shutter_of(const Pose& cam_from_before, double time) const {
  const double dt = time - time_before_;
  Shutter shutter;
  shutter.readout = options_.map.unskew ? readout_.seconds() : 0;
  if (!(dt > 0)) return shutter;
  // Stamps jitter by more than cameras do: over some frames.
  const Eigen::Matrix3d world_from_cam = world_from_before_.R * cam_from_before.R.transpose();
  if (turned_.empty() || !(time > turned_.front().first)) {
    shutter.turn_rate = so3_log(cam_from_before.R.transpose()) / dt;
  } else {
    shutter.turn_rate =
        so3_log(turned_.front().second.transpose() * world_from_cam) / (time - turned_.front().first);
  }
  return shutter;
}

MapMatch MapTracker::match_of(const PointRef& ref, const Eigen::Vector3d& ray, double row, double sigma_px,
                              const Shutter& shutter) const {
  const Keyframe& host = map_.at(ref.keyframe);
  const MapPoint& point = host.points[ref.point];
  const Pose before_from_host = world_from_before_.inverse() * host.world_from_cam;
  const double sigma = std::max(options_.map.least_sigma_px, sigma_px) / std::abs(camera_.fx);
  MapMatch match;
  match.X = before_from_host * point.position();
  match.S = before_from_host.R * point.covariance() * before_from_host.R.transpose();
  match.ray = shutter.at_middle(ray, row);
  match.sigma = sigma;
  match.z = kUnmeasured;
  return match;
}

std::optional<FirstPose> MapTracker::find_first_pose(const MapFrame& frame, const Pose& predicted,
                                                     const std::vector<int>& keyframes, int& matched) const {
  const Pose predicted_from_before = predicted.inverse() * world_from_before_;
  FirstPoseOptions options;
  options.max_error = 4 / std::abs(camera_.fx);
  options.min_inliers = options_.map.min_inliers;
  options.ransac = options_.ransac;
  options.ransac.seed = options_.seed + 0x9e3779b97f4a7c15ull * (frame.index + 1);
  const Shutter shutter = shutter_of(predicted_from_before, frame.time);
  const auto attempt = [&](const std::vector<FeatureOfPoint>& found) {
    std::vector<MapMatch> matches;
    for (const FeatureOfPoint& match : found)
      matches.push_back(match_of(match.ref, frame.rays[match.feature],
                                 row_of(camera_, frame.pixel(match.feature).y()), 1.0, shutter));
    matched = std::max(matched, static_cast<int>(matches.size()));
    return first_pose(matches, predicted_from_before, options);
  };
  const auto visible = points_in_view(map_, keyframes, predicted, camera_, shutter);
  constexpr double kSettledPx = 4, kWider = 4;
  const auto known = settled(visible, kSettledPx);
  const auto near = match_in_window(map_, known, frame, options_.map.window_px);
  if (auto pose = attempt(near); pose && 3 * pose->inliers > static_cast<int>(near.size())) return pose;
  // Where the camera began or ended to turn since the frame before.
  const auto wide = match_in_window(map_, known, frame, kWider * options_.map.window_px);
  if (auto pose = attempt(wide); pose && pose->inliers > 2 * options.min_inliers) return pose;
  std::optional<FirstPose> best;
  for (auto id = keyframes.rbegin(); id != keyframes.rend(); ++id) {
    const auto pose = attempt(match_anywhere(map_.at(*id), frame));
    if (pose && (!best || pose->inliers > best->inliers)) best = pose;
    if (best && best->inliers > 2 * options.min_inliers) break;
  }
  return best;
}

MapTracker::Placed MapTracker::refine(const MapFrame& frame, const Pose& cam_from_before,
                                      const std::vector<int>& keyframes, int coarser, int max_points) const {
  Placed placed;
  placed.pose.cam_from_reference = cam_from_before;
  const Pose world_from_cam = world_from_before_ * cam_from_before.inverse();
  placed.shutter = shutter_of(cam_from_before, frame.time);
  constexpr double kSettledPx = 2;  // half of what patches find
  const auto visible =
      settled(points_in_view(map_, keyframes, world_from_cam, camera_, placed.shutter), kSettledPx);
  placed.points = track_map_points(map_, visible, frame, world_from_cam, camera_, coarser, max_points);
  placed.sought = std::min(max_points, static_cast<int>(visible.size()));
  placed.matched = static_cast<int>(placed.points.size());
  if (static_cast<int>(placed.points.size()) < options_.map.min_inliers) return placed;
  // Between the frame before and this one the camera turned as it turns while depth is late.
  const double dt = frame.time - time_before_;
  const double share = options_.map.follow && dt > 0 ? frame.depth_delay / dt : 0;
  const Pose depth_from_cam = {so3_exp(share * so3_log(cam_from_before.R)), share * cam_from_before.t};
  for (const TrackedPoint& point : placed.points) {
    const double row = row_of(camera_, point.pixel.y());
    MapMatch match = match_of(point.ref, point.ray, row, point.sigma_px, placed.shutter);
    if (const auto plane = depth_along(frame, point.ray, depth_from_cam, camera_, options_)) {
      match.z = placed.shutter.depth_at_middle(point.ray, row, plane->z);
      match.z_share = plane->noise_share;
    }
    const Keyframe& host = map_.at(point.ref.keyframe);
    const MapPoint& map_point = host.points[point.ref.point];
    const Eigen::Matrix3d cam_from_host =
        cam_from_before.R * world_from_before_.R.transpose() * host.world_from_cam.R;
    const Eigen::Vector3d by_host =
        cam_from_host * host.shutter.at_middle_by_readout(
                            map_point.ray, row_of(camera_, host.frame->pixel(map_point.feature).y()));
    const Eigen::Vector2d host_skew = (by_host - by_host.z() * match.ray).head<2>();
    const Eigen::Vector2d own_skew = placed.shutter.at_middle_by_readout(match.ray, row).head<2>();
    match.by_readout = host_skew - own_skew;
    match.skew = std::max(host_skew.norm(), own_skew.norm());
    placed.matches.push_back(match);
  }
  placed.pose = refine_map_pose(placed.matches, cam_from_before, options_.depth_noise);
  return placed;
}

Correspondences MapTracker::seen_from_before(const Placed& placed) const {
  Correspondences seen;
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const MapMatch& match = placed.matches[i];
    seen.pixels1.push_back(camera_.project(match.X).value_or(placed.points[i].pixel));
    seen.pixels2.push_back(placed.points[i].pixel);
    seen.x1.push_back(match.X.normalized());
    seen.x2.push_back(match.ray.normalized());
    seen.z1.push_back(match.X.z());
    seen.z2.push_back(match.z);
    seen.sigma1.push_back(match.sigma);
    seen.sigma2.push_back(match.sigma);
    seen.distance.push_back(0);
  }
  return seen;
}

MapTrack MapTracker::measured(std::shared_ptr<MapFrame> frame, const Placed& placed) {
  MapTrack track;
  const Pose& cam_from_before = placed.pose.cam_from_reference;
  track.world_from_cam =
      motion_.update(frame->time, world_from_before_ * cam_from_before.inverse(),
                     of_placed_camera(placed.pose.covariance, cam_from_before, world_from_before_.R));
  track.step.status = Status::kOk;
  track.step.matches = placed.matched;
  track.step.inliers = placed.pose.num_inliers;
  track.step.iterations = placed.iterations;
  track.step.inlier_mask.assign(placed.pose.inliers.begin(), placed.pose.inliers.end());
  track.seen = seen_from_before(placed);
  track.seen.has_depth = !frame->depth.empty();
  const Pose world_from_earlier = world_from_earlier_ = world_from_before_;
  const double dt = frame->time - time_before_;
  const Matrix6d own = in_own_axes(placed.pose.own_covariance, cam_from_before);
  // Of a step between two placed cameras, each with its own error.
  track.step.covariance =
      chained({cam_from_before, placed.pose.own_covariance}, {Pose(), covariance_before_}).covariance;

  const auto correction = readout_correction(placed.matches, placed.pose);
  if (options_.map.unskew)
    readout_.add(correction.seconds, correction.information, frame->time - time_before_);
  shutter_ = placed.shutter;
  if (trajectory_.size() == 1) map_.at(0).shutter = shutter_;  // as the first frame turned, most likely
  world_from_before_ = track.world_from_cam;
  covariance_before_ = own;
  time_before_ = time_measured_ = frame->time;
  if (dt > 0) speed_ = (world_from_before_.t - world_from_earlier.t).norm() / dt;
  const auto traced = look_for_depth(*frame, placed);
  if (wants_keyframe(placed))
    become_keyframe(frame, track.world_from_cam, &placed, traced);
  else if (options_.map.fuse)
    fuse_depth(placed);
  track.world_from_cam = world_from_before_;
  track.step.cam2_from_cam1 = track.world_from_cam.inverse() * world_from_earlier;
  steady_ = motion_;
  remember(*frame, track.world_from_cam);
  return track;
}

MapTrack MapTracker::missed(std::shared_ptr<MapFrame> frame) {
  MapTrack track;
  motion_.coast(frame->time);
  track.world_from_cam = motion_.predict(frame->time);
  track.step.status =
      frame->time - time_measured_ <= options_.map.max_coast ? Status::kPredicted : Status::kLost;
  track.step.cam2_from_cam1 = track.world_from_cam.inverse() * world_from_before_;
  world_from_before_ = track.world_from_cam;
  time_before_ = frame->time;
  // What is not found again is a new place: a map goes on from where the camera is believed to be.
  constexpr int kEnoughToSee = 200;
  if (track.step.status == Status::kLost && static_cast<int>(frame->rays.size()) >= kEnoughToSee) {
    has_points_ = frame->has_depth;
    become_keyframe(frame, track.world_from_cam, nullptr);
    time_measured_ = frame->time;
  }
  remember(*frame, track.world_from_cam);
  return track;
}

void MapTracker::become_keyframe(std::shared_ptr<MapFrame> frame, const Pose& world_from_cam,
                                 const Placed* placed, const std::vector<TrackedPoint>& traced) {
  describe(*frame, camera_, options_.map);
  Keyframe& keyframe = map_.add(frame, world_from_cam);
  keyframe.shutter = shutter_;
  map_.set_readout(readout_.seconds(), camera_);
  std::vector<TrackedPoint> taken;
  int seen = 0;
  if (placed)
    for (std::size_t i = 0; i < placed->points.size(); ++i) {
      if (!placed->pose.inliers[i]) continue;
      taken.push_back(placed->points[i]);
      const PointRef& ref = placed->points[i].ref;
      if (!map_.holds(ref.keyframe)) continue;
      const MapMatch& match = placed->matches[i];
      map_.point(ref).views.push_back({keyframe.id, match.ray,
                                       std::max(1.0, placed->pose.ray_scale) * match.sigma, match.z,
                                       placed->points[i].ray, row_of(camera_, placed->points[i].pixel.y())});
      seen += map_.point(ref).is_known();
    }
  for (const TrackedPoint& point : traced) {
    if (!map_.holds(point.ref.keyframe)) continue;
    taken.push_back(point);
    const double row = row_of(camera_, point.pixel.y());
    map_.point(point.ref).views.push_back(
        {keyframe.id, keyframe.shutter.at_middle(point.ray, row),
         std::max(options_.map.least_sigma_px, point.sigma_px) / std::abs(camera_.fx), kUnmeasured, point.ray,
         row});
    seen += map_.point(point.ref).is_known();
  }
  add_points(keyframe, taken);
  const int points_added = static_cast<int>(keyframe.points.size());
  has_points_ |= static_cast<int>(keyframe.points.size()) >= 2 * options_.map.min_inliers;
  const bool has_depth = !frame->depth.empty();
  frame->depth.release();  // its points have it
  if (placed && has_depth) grow();
  if (placed && (options_.map.adjust || !has_depth)) adjust();
  if (!has_depth) guess_points(map_.at(map_.newest_id()), taken);
  points_at_keyframe_ = std::min(options_.map.points, seen + points_added);
}

int MapTracker::count_known(const Placed& placed) const {
  int count = 0;
  for (std::size_t i = 0; i < placed.points.size(); ++i)
    count += placed.pose.inliers[i] && map_.point(placed.points[i].ref).is_known();
  return count;
}

bool MapTracker::wants_keyframe(const Placed& placed) const {
  const int known = count_known(placed);
  if (known < options_.map.keyframe_share * points_at_keyframe_) return true;
  // By how far the camera's own motion has shifted what it sees since the newest keyframe.
  const Keyframe& newest = map_.newest();
  if (newest.frame->has_depth) return false;
  const Pose newest_from_before = newest.world_from_cam.inverse() * world_from_earlier_;
  std::vector<double> shifts;
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const Eigen::Vector3d X = newest_from_before * placed.matches[i].X;
    if (!placed.pose.inliers[i] || X.z() <= 0) continue;
    const Eigen::Vector3d turned = world_from_before_.R.transpose() * newest.world_from_cam.R * X,
                          x = world_from_before_.inverse() * (newest.world_from_cam * X);
    if (turned.z() > 0 && x.z() > 0)
      shifts.push_back((turned.head<2>() / turned.z() - x.head<2>() / x.z()).norm());
  }
  if (shifts.empty()) return true;
  const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(shifts.size() / 2);
  std::nth_element(shifts.begin(), middle, shifts.end());
  return *middle * std::abs(camera_.fx) > options_.map.keyframe_shift * camera_.width;
}

// What a frame without depth says of how far the points are that it sees.
std::vector<TrackedPoint> MapTracker::look_for_depth(const MapFrame& frame, const Placed& placed) {
  constexpr int kBack = 4;
  constexpr double kMaxErrorPx = 2, kSurePx = 0.5, kWellKnown = 0.03;
  if (!frame.depth.empty()) return {};
  const double focal = std::abs(camera_.fx);
  const Pose cam_from_world = world_from_before_.inverse();
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    if (!placed.pose.inliers[i]) continue;
    MapPoint& point = map_.point(placed.points[i].ref);
    if (point.is_given_up || point.variance < std::pow(kWellKnown * point.inverse_z, 2)) continue;
    const Pose cam_from_host = cam_from_world * map_.at(placed.points[i].ref.keyframe).world_from_cam;
    take_in(point, placed.matches[i].ray, std::max(kSurePx, placed.points[i].sigma_px) / focal, cam_from_host,
            kMaxErrorPx / focal);
  }
  std::vector<int> newest;
  for (int id = std::max(map_.first_id(), map_.newest_id() + 1 - kBack); id <= map_.newest_id(); ++id)
    newest.push_back(id);
  std::vector<PointRef> tracked;
  for (const TrackedPoint& point : placed.points) tracked.push_back(point.ref);
  return trace_points(map_, newest, tracked, frame, world_from_before_, placed.shutter, camera_);
}

void MapTracker::guess_points(Keyframe& keyframe, const std::vector<TrackedPoint>& taken) {
  const Pose cam_from_world = keyframe.world_from_cam.inverse();
  std::vector<Eigen::Vector2d> places;
  std::vector<DepthAtPixel> known;
  for (const TrackedPoint& point : taken) {
    places.push_back(point.pixel);
    if (!map_.holds(point.ref.keyframe)) continue;
    const MapPoint& map_point = map_.point(point.ref);
    const double z =
        (cam_from_world * (map_.at(point.ref.keyframe).world_from_cam * map_point.position())).z();
    if (map_point.is_known() && z > 0) known.push_back({point.pixel, 1 / z});
  }
  add_guessed_points(keyframe, places, known, camera_);
}

// Points that no depth image tells, from the keyframes before.
void MapTracker::grow() {
  constexpr int kBack = 2;
  const int newest = map_.newest_id();
  for (int id = std::max(map_.first_id(), newest - kBack); id < newest; ++id)
    grow_map(map_, id, newest, camera_);
}

void MapTracker::adjust() {
  constexpr int kMoving = 6;
  const int newest = map_.newest_id();
  const Pose before = map_.newest().world_from_cam;
  const auto ids =
      keyframes_in_view(map_, before, camera_, kMoving + options_.map.newest / 2, options_.map.others);
  std::vector<int> moving, still;
  for (const int id : ids) (id > newest - kMoving && id > ids.front() ? moving : still).push_back(id);
  WindowOptions options;
  options.depth_noise = options_.depth_noise;
  const bool learns_lens = options_.map.learn_lens && camera_.model == CameraModel::kPinhole;
  if (learns_lens) options.lens_information = lens_information_ / kLensShare;
  const WindowSummary window = adjust_window(map_, moving, still, options);
  if (learns_lens) learn_lens(window);
  const Pose& after = map_.newest().world_from_cam;
  motion_.correct(after * before.inverse());
  world_from_before_ = after;
}

// What windows say of the lens is taken as they share most of their views with the ones before, and as what
// else they leave is alike in neighbours: they count for a share of what they hold.
//   How far calibrations are off: Cvišić, Marković, Petrović, Recalibrating the KITTI dataset camera setup
//   for improved odometry accuracy, ECMR 2021.
void MapTracker::learn_lens(const WindowSummary& window) {
  constexpr double kMost = 1 / (0.0005 * 0.0005);  // it may still be learned anew
  constexpr double kNothing = 2e-5;                // a hundredth of a pixel at a corner
  lens_information_ = std::min(kMost, std::max(lens_information_, kLensShare * window.lens_information));
  if (!(std::abs(window.lens_correction) > kNothing)) return;
  Camera learned = camera_;
  learned.distortion[0] += window.lens_correction;
  map_.set_camera(camera_, learned);
  camera_ = learned;
}

// What a frame's depth says of the points it sees, until it is known as well as that: depth errors of one
// place are alike from frame to frame.
void MapTracker::fuse_depth(const Placed& placed) {
  constexpr double kMostLooks = 10;
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const MapMatch& match = placed.matches[i];
    if (!placed.pose.inliers[i] || !(match.z > 0)) continue;
    const PointRef& ref = placed.points[i].ref;
    MapPoint& point = map_.point(ref);
    const Pose host_from_cam = map_.at(ref.keyframe).world_from_cam.inverse() * world_from_before_;
    const double z = (host_from_cam * (match.z * match.ray)).z();
    if (!(z > 0)) continue;
    const double sigma =
        placed.pose.depth_scale * match.z_share * options_.depth_noise.sigma(match.z) / (z * z);
    const double information = 1 / (sigma * sigma), most = kMostLooks * information;
    const double seen = 1 / z;
    if (std::abs(seen - point.inverse_z) > 3 * std::sqrt(point.variance + sigma * sigma)) continue;
    if (point.information >= most) continue;
    const double sum = point.information + information;
    point.measured = (point.information * point.measured + information * seen) / sum;
    point.information = sum;
    const double known = 1 / point.variance;
    point.inverse_z = (known * point.inverse_z + information * seen) / (known + information);
    point.variance = 1 / (known + information);
  }
}

void MapTracker::add_points(Keyframe& keyframe, const std::vector<TrackedPoint>& taken) {
  const MapFrame& frame = *keyframe.frame;
  if (frame.levels.empty()) return;
  constexpr double kApartPx = 6;
  cv::Mat free(frame.levels[0].size(), CV_8U, cv::Scalar(1));
  const auto take = [&](const Eigen::Vector2d& pixel) {
    const int r = static_cast<int>(kApartPx);
    const cv::Rect around(static_cast<int>(pixel.x()) - r, static_cast<int>(pixel.y()) - r, 2 * r + 1,
                          2 * r + 1);
    free(around & cv::Rect(0, 0, free.cols, free.rows)).setTo(0);
  };
  for (const TrackedPoint& point : taken) take(point.pixel);
  const Pose depth_from_cam = options_.map.follow ? motion_.motion_during(frame.depth_delay) : Pose();
  for (int i = 0; i < static_cast<int>(frame.rays.size()); ++i) {
    const Eigen::Vector2d pixel = frame.pixel(i);
    const int u = std::clamp(static_cast<int>(std::lround(pixel.x())), 0, free.cols - 1);
    const int v = std::clamp(static_cast<int>(std::lround(pixel.y())), 0, free.rows - 1);
    if (free.at<std::uint8_t>(v, u) == 0) continue;
    const auto plane = depth_along(frame, frame.rays[i], depth_from_cam, camera_, options_);
    if (!plane) continue;
    take(pixel);
    const double row = row_of(camera_, pixel.y());
    const double z_middle = keyframe.shutter.depth_at_middle(frame.rays[i], row, plane->z);
    const double sigma = plane->noise_share * options_.depth_noise.sigma(z_middle) / (z_middle * z_middle);
    MapPoint point{
        i, keyframe.shutter.at_middle(frame.rays[i], row), 1 / z_middle, sigma * sigma, 0, 0, {}, 0, 0};
    point.slope = plane->slope;
    point.measured = point.inverse_z;
    point.information = 1 / point.variance;
    keyframe.points.push_back(point);
  }
}

void MapTracker::remember(const MapFrame& frame, const Pose& world_from_cam) {
  constexpr std::size_t kTurns = 3;
  turned_.emplace_back(frame.time, world_from_cam.R);
  if (turned_.size() > kTurns) turned_.pop_front();
  const int id = map_.newest_id();
  trajectory_.push_back({id, map_.at(id).world_from_cam.inverse() * world_from_cam});
}

std::vector<Pose> MapTracker::final_poses() const {
  std::vector<Pose> poses;
  for (const Anchored& frame : trajectory_)
    poses.push_back(map_.last_pose_of(frame.keyframe) * frame.keyframe_from_cam);
  return poses;
}

}  // namespace framewise
