// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "framewise/odometry/anchored_trajectory.h"
#include "framewise/odometry/keyframe_choice.h"
#include "framewise/odometry/lens_estimate.h"
#include "framewise/odometry/map_placement.h"
#include "framewise/odometry/motion_filter.h"
#include "framewise/odometry/odometer.h"
#include "framewise/odometry/two_view_start.h"

namespace framewise {

// A frame's place in the map.
struct MapTrack {
  Step step;  // from the frame before
  Pose world_from_cam;
  Correspondences seen;  // map points: where the frame before would see them and where this one does
};

// What a recording taught of its camera.
struct LearnedCamera {
  double k1_correction = 0;  // of the first radial coefficient, to be added to the calibration's
  double readout = 0;        // of the rolling shutter, first row to last (s)
};

// The default odometer's serial part: frames come in their order, and each is placed against the keyframes
// and points of the ones before.
class MapTracker {
 public:
  // known: for scale "truth", of a camera without depth.
  MapTracker(const Camera& camera, const OdometryOptions& options, PriorKnowledge known = {});

  MapTrack add(std::shared_ptr<MapFrame> frame);

  // world_from_cam of all frames as the keyframes ended: what the frames after them taught is in it.
  std::vector<Pose> final_poses() const { return trajectory_.poses(map_); }

  LearnedCamera learned() const { return {lens_.correction(), readout_.seconds()}; }

 private:
  MapTrack start(std::shared_ptr<MapFrame> frame);
  MapTrack start_without_depth(std::shared_ptr<MapFrame> frame);
  void build_from_two_views(std::shared_ptr<MapFrame> frame, const TwoViewStart& two_views, double length);
  void place_waiting();
  std::optional<double> first_length(const MapFrame& frame1, const MapFrame& frame2,
                                     const TwoViewStart& two_views) const;
  MapTrack measured(std::shared_ptr<MapFrame> frame, const Placed& placed);
  MapTrack missed(std::shared_ptr<MapFrame> frame);
  std::optional<MapTrack> follow_meanwhile(std::shared_ptr<MapFrame> frame);
  bool is_under_way() const;
  void go_on_as_meanwhile();

  MapView view() const;
  std::optional<Placed> find(const std::shared_ptr<MapFrame>& frame, FrameView& frame_view);
  void follow_errors(const Placed& placed);
  void become_keyframe(std::shared_ptr<MapFrame> frame, const Pose& world_from_cam, const Placed* placed,
                       const std::vector<TrackedPoint>& traced = {}, bool adjusts = false);
  KeyframeNeed need_of_keyframe(const Placed& placed) const;
  int grow();
  void adjust();
  void remember(const MapFrame& frame, const Pose& world_from_cam);

  Camera camera_;
  OdometryOptions options_;
  PriorKnowledge known_;
  LocalMap map_;
  double usual_noise_px_ = 0;  // of placed frames
  MotionFilter motion_;
  MotionFilter steady_{false};  // as it was at the last measured frame: vehicles do not stop in the dark
  Pose world_from_before_, world_from_earlier_;  // the frame before, and the one before that
  double time_before_ = 0, time_measured_ = 0;
  PoseErrors errors_;
  Matrix6d foretold_ = Matrix6d::Zero();  // how far the camera may have departed since it was measured
  int missed_in_a_row_ = 0, measured_in_a_row_ = 0, foretold_in_a_row_ = 0;
  FrameView last_measured_;  // to relate a frame to where the map fails
  Pose world_from_measured_;
  int points_at_keyframe_ = 0;
  std::size_t keyframe_at_ = 0;  // the newest keyframe's place in the trajectory
  ReadoutEstimate readout_;
  LensEstimate lens_;
  Shutter shutter_;  // of the newest frame
  RecentTurns turns_;
  double speed_ = 0;         // of the camera, when it was last measured (m/s, or the map's unit)
  bool is_metric_ = false;   // by depth that was seen
  bool has_points_ = false;  // the map has a length and can be tracked against
  AnchoredTrajectory trajectory_;
  // Frames that a map without depth has begun after, by their place in the trajectory.
  std::vector<std::pair<std::size_t, std::shared_ptr<const MapFrame>>> waiting_;
  // While the map is not seen, what is seen instead: a map of its own, begun where the camera was believed to
  // be then.
  std::unique_ptr<MapTracker> meanwhile_;
  Pose world_from_meanwhile_;
};

}  // namespace framewise
