// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/keyframe_choice.h"
#include "framewise/odometry/map_growth.h"
#include "framewise/odometry/points_with_depth.h"
#include "framewise/odometry/points_without_depth.h"

namespace framewise {
namespace {

constexpr int kUnderWay = 3;  // frames measured in a row: not by chance
constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

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

bool MapTracker::is_under_way() const { return measured_in_a_row_ >= kUnderWay; }

MapTrack MapTracker::add(std::shared_ptr<MapFrame> frame) {
  if (map_.empty()) return start(std::move(frame));
  if (!has_points_) return start_without_depth(std::move(frame));
  FrameView frame_view(*frame);
  const auto placed = find(frame, frame_view);
  measured_in_a_row_ = placed ? measured_in_a_row_ + 1 : 0;
  if (!placed) return missed(std::move(frame));
  // Back from another map, which did not know where it was: a step that no two frames tell.
  const bool is_jump = meanwhile_ && meanwhile_->is_under_way();
  meanwhile_.reset();
  foretold_in_a_row_ = placed->is_foretold ? foretold_in_a_row_ + 1 : 0;
  MapTrack track = measured(std::move(frame), *placed);
  if (is_jump) track.step.status = Status::kPredicted;
  last_measured_ = std::move(frame_view);
  world_from_measured_ = track.world_from_cam;
  return track;
}

std::optional<Placed> MapTracker::find(const std::shared_ptr<MapFrame>& frame, FrameView& frame_view) {
  std::optional<Placed> unsure;
  const Pose predicted = motion_.predict(frame->time);
  if (const auto placed = place(*frame, predicted, view(), unsure)) return placed;
  const bool was_missed = time_before_ > time_measured_;
  if (was_missed)
    if (const auto placed = place(*frame, steady_.predict(frame->time), view(), unsure)) return placed;
  const auto by = [&](auto* place_by) {
    return place_by(*frame, frame_view, last_measured_, world_from_measured_, predicted, view());
  };
  const bool has_depth = !last_measured_.frame().depth.empty();
  if (const auto placed = by(has_depth ? place_by_pair : place_by_views)) return placed;
  // A motion that goes on as foretold makes up for what the patches leave to chance.
  if (unsure && is_under_way()) return unsure;
  auto by_views = has_depth ? by(place_by_views) : std::nullopt;
  if (!by_views || !by_views->is_foretold) return by_views;
  // Where all that is seen is far, and for a few frames, a steady motion makes up for the translation.
  constexpr int kMostForetold = 3;
  if (!is_under_way() || foretold_in_a_row_ == kMostForetold) return std::nullopt;
  Matrix6d& covariance = by_views->pose.covariance;
  if (!covariance.topLeftCorner<3, 3>().allFinite()) return std::nullopt;
  covariance.rightCols<3>().setZero(), covariance.bottomRows<3>().setZero();
  covariance.bottomRightCorner<3, 3>() = motion_.departure().bottomRightCorner<3, 3>();
  return by_views;
}

MapTrack MapTracker::start(std::shared_ptr<MapFrame> frame) {
  MapTrack track;
  track.step.status = Status::kOk;
  track.step.covariance.setZero();
  motion_.start(frame->time, {});
  time_before_ = time_measured_ = frame->time;
  last_measured_ = FrameView(*frame);
  become_keyframe(frame, {}, nullptr);
  remember(*frame, {});
  return track;
}

MapView MapTracker::view() const {
  return {map_,         camera_,        options_, turns_, readout_.seconds(), world_from_before_,
          time_before_, usual_noise_px_};
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
  if (const auto length = first_length(*first.frame, *frame, two_views)) {
    build_from_two_views(frame, two_views, *length);
    track.step.status = Status::kOk;
    track.world_from_cam = map_.newest().world_from_cam;
  } else if (two_views.kind == TwoViewStart::Kind::kTurned) {
    track.step.status = Status::kRotationOnly;
    track.world_from_cam = {first.world_from_cam.R * two_views.cam2_from_cam1.R.transpose(),
                            first.world_from_cam.t};
  }
  track.step.cam2_from_cam1 = track.world_from_cam.inverse() * world_from_before_;
  world_from_before_ = track.world_from_cam;
  errors_.moved(track.world_from_cam, Matrix6d::Zero());  // the map's length and axes are these frames'
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
  constexpr int kCoarser = 2;
  const int newest = map_.newest_id(), first = newest - 1;
  const Pose world_from_first = map_.at(first).world_from_cam;
  const double start = map_.at(first).frame->time, seconds = map_.at(newest).frame->time - start;
  for (const auto& [index, frame] : waiting_) {
    const double share = seconds > 0 ? std::clamp((frame->time - start) / seconds, 0.0, 1.0) : 0;
    Pose guess = trajectory_.pose(index, map_);
    guess.t = world_from_first.t + share * (map_.newest().world_from_cam.t - world_from_first.t);
    const Placed placed = place_near(*frame, guess.inverse() * world_from_before_, {first, newest}, kCoarser,
                                     options_.map.points, view());
    if (!is_credible(placed, options_.map)) continue;
    const Pose world_from_cam = world_from_before_ * placed.pose.cam_from_reference.inverse();
    trajectory_.replace(index, first, world_from_cam, map_);
  }
  waiting_.clear();
}

// By depth where there is some; else a new part of the map goes on as fast as the last one ended, unless that
// was in metres, which no guess is. The first part of all begins with the truth's length or with 1.
std::optional<double> MapTracker::first_length(const MapFrame& frame1, const MapFrame& frame2,
                                               const TwoViewStart& two_views) const {
  if (two_views.kind != TwoViewStart::Kind::kTriangulated) return std::nullopt;
  if (const auto length = length_by_depth(two_views, frame2, camera_, options_)) return length;
  if (is_metric_) return std::nullopt;
  if (const double length = speed_ * (frame2.time - frame1.time); length > 0) return length;
  if (options_.scale != "truth" || !known_.truth) return 1;
  const auto pose1 = known_.truth(frame1.index), pose2 = known_.truth(frame2.index);
  const double length = pose1 && pose2 ? (pose2->t - pose1->t).norm() : 0;
  return length > 0 ? length : 1;
}

void MapTracker::build_from_two_views(std::shared_ptr<MapFrame> frame, const TwoViewStart& two_views,
                                      double length) {
  last_measured_ = FrameView(*frame);
  const SeenByBoth seen = add_two_views(map_, std::move(frame), two_views, length, camera_, options_.map);
  errors_.become_keyframe(map_.first_id());
  const int viewer = map_.newest_id(), host = viewer - 1;
  has_points_ = true;
  world_from_measured_ = map_.newest().world_from_cam;
  points_at_keyframe_ = std::min(options_.map.points, static_cast<int>(map_.at(host).points.size()));
  world_from_before_ = map_.newest().world_from_cam;
  adjust();
  guess_points(map_, host, seen.by_first, camera_);
  guess_points(map_, viewer, seen.by_second, camera_);
}

MapTrack MapTracker::measured(std::shared_ptr<MapFrame> frame, const Placed& placed) {
  MapTrack track;
  const Pose& cam_from_before = placed.pose.cam_from_reference;
  track.world_from_cam =
      motion_.update(frame->time, world_from_before_ * cam_from_before.inverse(),
                     of_placed_camera(placed.pose.covariance, cam_from_before, world_from_before_.R));
  follow_errors(placed);
  track.step.status = placed.is_foretold ? Status::kLowParallax : Status::kOk;
  track.step.matches = placed.matched;
  track.step.inliers = placed.pose.num_inliers;
  track.step.iterations = placed.iterations;
  track.step.inlier_mask.assign(placed.pose.inliers.begin(), placed.pose.inliers.end());
  track.seen = seen_from_before(placed, camera_);
  track.seen.has_depth = !frame->depth.empty();
  const Pose world_from_earlier = world_from_earlier_ = world_from_before_;
  const double dt = frame->time - time_before_;
  // Points without depth bend with the skew and hide it.
  if (const auto correction = readout_correction(placed.matches, placed.pose);
      options_.map.unskew && !frame->depth.empty())
    readout_.add(correction.seconds, correction.information, dt);
  shutter_ = placed.shutter;
  if (trajectory_.size() == 1) map_.at(0).shutter = shutter_;  // as the first frame turned, most likely
  world_from_before_ = track.world_from_cam;
  time_before_ = time_measured_ = frame->time;
  if (dt > 0) speed_ = (world_from_before_.t - world_from_earlier.t).norm() / dt;
  std::vector<TrackedPoint> traced;
  if (frame->depth.empty()) traced = look_for_depth(map_, placed, *frame, world_from_before_, camera_);
  if (const KeyframeNeed need = need_of_keyframe(placed); wants_keyframe(need, camera_.width, options_.map)) {
    const bool follows_keyframe = trajectory_.size() == keyframe_at_ + 1;
    const bool adjusts =
        frame->depth.empty() || needs_adjustment(need, follows_keyframe, camera_.width, options_.map);
    become_keyframe(frame, track.world_from_cam, &placed, traced, adjusts);
  } else if (options_.map.fuse) {
    take_in_depths(map_, placed, world_from_before_, options_.depth_noise);
  }
  track.world_from_cam = world_from_before_;
  track.step.cam2_from_cam1 = track.world_from_cam.inverse() * world_from_earlier;
  track.step.covariance = errors_.step_covariance(world_from_earlier, track.world_from_cam);
  steady_ = motion_;
  remember(*frame, track.world_from_cam);
  return track;
}

void MapTracker::follow_errors(const Placed& placed) {
  const Pose& cam_from_before = placed.pose.cam_from_reference;
  const Pose world_from_cam = world_from_before_ * cam_from_before.inverse();
  if (placed.matches.empty()) {
    errors_.moved(world_from_cam, foretold_ + of_placed_camera(placed.pose.covariance, cam_from_before,
                                                               world_from_before_.R));
  } else {
    errors_.placed(world_from_cam, placed_by(placed, options_.depth_noise));
    errors_.drawn_to_prior(world_from_cam, motion_.draw());
    constexpr double kMemory = 0.1;
    const double noise = shown_noise_px(placed, options_.map);
    usual_noise_px_ += (usual_noise_px_ > 0 ? kMemory : 1) * (noise - usual_noise_px_);
  }
  foretold_.setZero();
  missed_in_a_row_ = 0;
}

MapTrack MapTracker::missed(std::shared_ptr<MapFrame> frame) {
  MapTrack track;
  const Pose world_from_earlier = world_from_before_;
  ++missed_in_a_row_;  // the first changes the speed of all that follow
  const Matrix6d departure = missed_in_a_row_ * missed_in_a_row_ * motion_.departure();
  motion_.coast(frame->time);
  world_from_before_ = motion_.predict(frame->time);
  const auto meanwhile = follow_meanwhile(frame);
  track.world_from_cam = world_from_before_;
  const bool is_late = frame->time - time_measured_ > options_.map.max_coast;
  errors_.moved(track.world_from_cam, departure);
  foretold_ += departure;
  if (meanwhile && meanwhile_->is_under_way()) {
    track.step = meanwhile->step;
    track.seen = meanwhile->seen;
  } else {
    const bool is_end = meanwhile && meanwhile_->measured_in_a_row_ + 1 == kUnderWay;  // of what is one part
    track.step.status = is_late || is_end ? Status::kLost : Status::kPredicted;
    track.step.covariance = errors_.step_covariance(world_from_earlier, track.world_from_cam);
  }
  track.step.cam2_from_cam1 = track.world_from_cam.inverse() * world_from_earlier;
  time_before_ = frame->time;
  // What is not found again is given up for what is seen instead.
  if (is_late && meanwhile) go_on_as_meanwhile();
  remember(*frame, track.world_from_cam);
  return track;
}

// A camera that does not see the map may well see how it moves. Whether it does: what is no place (noise, a
// wall) is not found again in the next frame.
std::optional<MapTrack> MapTracker::follow_meanwhile(std::shared_ptr<MapFrame> frame) {
  if (meanwhile_) {
    // It may keep the frame and let its depth go, and be given up all the same.
    const MapTrack track = meanwhile_->add(std::make_shared<MapFrame>(*frame));
    if (track.step.status == Status::kRotationOnly) {
      world_from_before_.R = world_from_meanwhile_.R * track.world_from_cam.R;
      return track;
    }
    if (is_measured(track.step.status)) {
      world_from_before_ = world_from_meanwhile_ * track.world_from_cam;
      motion_ = meanwhile_->motion_;
      motion_.correct(world_from_meanwhile_);
      return track;
    }
  }
  meanwhile_ = std::make_unique<MapTracker>(camera_, options_, known_);
  meanwhile_->lens_ = lens_;
  meanwhile_->readout_ = readout_;
  meanwhile_->speed_ = speed_;
  meanwhile_->is_metric_ = is_metric_;
  meanwhile_->add(frame);
  world_from_meanwhile_ = world_from_before_;
  meanwhile_->motion_ = motion_;
  meanwhile_->motion_.correct(world_from_meanwhile_.inverse());
  return std::nullopt;
}

void MapTracker::go_on_as_meanwhile() {
  const std::unique_ptr<MapTracker> other = std::move(meanwhile_);
  map_.go_on_as(other->map_, world_from_meanwhile_);
  camera_ = other->camera_;
  lens_ = other->lens_;
  readout_ = other->readout_;
  shutter_ = other->shutter_;
  errors_.start(map_.first_id(), map_.newest_id() + 1 - map_.first_id());
  foretold_.setZero();
  missed_in_a_row_ = 0;
  last_measured_ = other->last_measured_;
  world_from_measured_ = world_from_meanwhile_ * other->world_from_measured_;
  points_at_keyframe_ = other->points_at_keyframe_;
  has_points_ = other->has_points_;
  speed_ = other->speed_;
  is_metric_ = other->is_metric_;
  time_measured_ = time_before_;
}

void MapTracker::become_keyframe(std::shared_ptr<MapFrame> frame, const Pose& world_from_cam,
                                 const Placed* placed, const std::vector<TrackedPoint>& traced,
                                 bool adjusts) {
  describe(*frame, camera_, options_.map);
  Keyframe& keyframe = map_.add(frame, world_from_cam);
  errors_.become_keyframe(map_.first_id());
  keyframe_at_ = trajectory_.size();
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
                                       match.noise * std::max(1.0, placed->pose.ray_scale), match.z,
                                       placed->points[i].ray, row_of(camera_, placed->points[i].pixel.y())});
      seen += map_.point(ref).is_known();
    }
  for (const TrackedPoint& point : traced) {
    if (!map_.holds(point.ref.keyframe)) continue;
    taken.push_back(point);
    const double row = row_of(camera_, point.pixel.y());
    const PlaceNoise noise = point.noise_px.at_least(options_.map.least_sigma_px) / std::abs(camera_.fx);
    map_.point(point.ref).views.push_back(
        {keyframe.id, keyframe.shutter.at_middle(point.ray, row), noise, kUnmeasured, point.ray, row});
    seen += map_.point(point.ref).is_known();
  }
  const Pose depth_from_cam = options_.map.follow ? motion_.motion_during(frame->depth_delay) : Pose();
  add_points_with_depth(keyframe, taken, depth_from_cam, camera_, options_);
  const int points_added = static_cast<int>(keyframe.points.size());
  if (static_cast<int>(keyframe.points.size()) >= 2 * options_.map.min_inliers)
    has_points_ = is_metric_ = true;
  const bool has_depth = !frame->depth.empty();
  frame->depth.release();  // its points have it
  if (placed && has_depth) seen += grow();
  if (adjusts) adjust();
  if (!has_depth) guess_points(map_, map_.newest_id(), taken, camera_);
  points_at_keyframe_ = std::min(options_.map.points, seen + points_added);
}

KeyframeNeed MapTracker::need_of_keyframe(const Placed& placed) const {
  const Keyframe& newest = map_.newest();
  KeyframeNeed need;
  need.known_at_keyframe = points_at_keyframe_;
  need.lives_on_motion = !newest.frame->has_depth;
  const Pose newest_from_before = newest.world_from_cam.inverse() * world_from_earlier_;
  std::vector<Eigen::Vector3d> seen;  // in the newest keyframe
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    if (!placed.pose.inliers[i]) continue;
    need.known += map_.point(placed.points[i].ref).is_known();
    seen.push_back(newest_from_before * placed.matches[i].X);
  }
  if (const auto shift = median_shift(seen, newest.world_from_cam, world_from_before_))
    need.shift_px = *shift * std::abs(camera_.fx);
  return need;
}

// Points that no depth image tells, from the keyframes before. Returns how many, all of which the newest
// keyframe sees.
int MapTracker::grow() {
  constexpr int kBack = 2;
  const int newest = map_.newest_id();
  int added = 0;
  for (int id = std::max(map_.first_id(), newest - kBack); id < newest; ++id)
    added += grow_map(map_, id, newest, camera_);
  return added;
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
  // With depth, a lens that is free only takes a part of what is a motion forwards.
  const bool learns_lens =
      options_.map.learn_lens && camera_.model == CameraModel::kPinhole && !map_.newest().frame->has_depth;
  if (learns_lens) options.lens_information = lens_.information_for_window();
  const WindowSummary window = adjust_window(map_, moving, still, options);
  if (const auto learned = learns_lens ? lens_.take_in(window, camera_) : std::nullopt) {
    map_.set_camera(camera_, *learned);
    camera_ = *learned;
  }
  const Pose& after = map_.newest().world_from_cam;
  motion_.correct(after * before.inverse());
  errors_.corrected(after * before.inverse());
  world_from_before_ = after;
}

void MapTracker::remember(const MapFrame& frame, const Pose& world_from_cam) {
  turns_.add(frame.time, world_from_cam.R);
  trajectory_.add(map_.newest_id(), world_from_cam, map_);
}

}  // namespace framewise
