// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "framewise/odometry/local_map.h"
#include "framewise/odometry/map_matching.h"
#include "framewise/odometry/map_pose.h"
#include "framewise/odometry/motion_filter.h"
#include "framewise/odometry/odometer.h"
#include "framewise/odometry/step.h"
#include "framewise/odometry/two_view_start.h"
#include "framewise/odometry/window_adjustment.h"

namespace framewise {

// A frame's place in the map.
struct MapTrack {
  Step step;  // from the frame before
  Pose world_from_cam;
  Correspondences seen;  // map points: where the frame before would see them and where this one does
};

// The default odometer's serial part: frames come in their order, and each is placed against the keyframes
// and points of the ones before.
class MapTracker {
 public:
  // known: for scale "truth", of a camera without depth.
  MapTracker(const Camera& camera, const OdometryOptions& options, PriorKnowledge known = {});

  MapTrack add(std::shared_ptr<MapFrame> frame);

  // world_from_cam of all frames as the keyframes ended: what the frames after them taught is in it.
  std::vector<Pose> final_poses() const;

 private:
  // A pose measured against the map, in the axes of the frame before.
  struct Placed {
    MapPose pose;
    std::vector<TrackedPoint> points;
    std::vector<MapMatch> matches;
    Shutter shutter;
    int sought = 0, matched = 0, iterations = 0;
  };

  Correspondences seen_from_before(const Placed& placed) const;
  MapTrack start(std::shared_ptr<MapFrame> frame);
  MapTrack start_without_depth(std::shared_ptr<MapFrame> frame);
  void build_from_two_views(std::shared_ptr<MapFrame> frame, TwoViewStart& two_views);
  void place_waiting();
  double first_length(const MapFrame& frame1, const MapFrame& frame2) const;
  MapTrack measured(std::shared_ptr<MapFrame> frame, const Placed& placed);
  MapTrack missed(std::shared_ptr<MapFrame> frame);

  std::optional<Placed> place(MapFrame& frame, const Pose& predicted) const;
  std::optional<Placed> look_nearby(const MapFrame& frame, Pose cam_from_before,
                                    const std::vector<int>& keyframes) const;
  bool is_credible(const Placed& placed) const;
  std::optional<FirstPose> find_first_pose(const MapFrame& frame, const Pose& predicted,
                                           const std::vector<int>& keyframes, int& matched) const;
  Placed refine(const MapFrame& frame, const Pose& cam_from_before, const std::vector<int>& keyframes,
                int coarser, int max_points) const;
  MapMatch match_of(const PointRef& ref, const Eigen::Vector3d& ray, double row, double sigma_px,
                    const Shutter& shutter) const;
  Shutter shutter_of(const Pose& cam_from_before, double time) const;
  void become_keyframe(std::shared_ptr<MapFrame> frame, const Pose& world_from_cam, const Placed* placed,
                       const std::vector<TrackedPoint>& traced = {});
  bool wants_keyframe(const Placed& placed) const;
  int count_known(const Placed& placed) const;
  std::vector<TrackedPoint> look_for_depth(const MapFrame& frame, const Placed& placed);
  void guess_points(Keyframe& keyframe, const std::vector<TrackedPoint>& taken);
  void add_points(Keyframe& keyframe, const std::vector<TrackedPoint>& taken);
  void grow();
  void adjust();
  void learn_lens(const WindowSummary& window);
  void fuse_depth(const Placed& placed);
  void remember(const MapFrame& frame, const Pose& world_from_cam);

  Camera camera_;
  OdometryOptions options_;
  PriorKnowledge known_;
  LocalMap map_;
  MotionFilter motion_;
  MotionFilter steady_{false};  // as it was at the last measured frame: vehicles do not stop in the dark
  Pose world_from_before_, world_from_earlier_;  // the frame before, and the one before that
  double time_before_ = 0, time_measured_ = 0;
  Matrix6d covariance_before_ = Matrix6d::Zero();  // in its own axes
  int points_at_keyframe_ = 0;
  ReadoutEstimate readout_;
  double lens_information_ = 1 / (0.02 * 0.02);  // of k1: what calibrations leave of it
  Shutter shutter_;                              // of the newest frame
  // Of the frames before: when, and how they were turned.
  std::deque<std::pair<double, Eigen::Matrix3d>> turned_;
  double speed_ = 0;         // of the camera, when it was last measured (m/s, or the map's unit)
  bool has_points_ = false;  // the map has a length and can be tracked against

  // Of every frame: the keyframe it is told by.
  struct Anchored {
    int keyframe;
    Pose keyframe_from_cam;
  };
  std::vector<Anchored> trajectory_;
  // Frames that a map without depth has begun after, by their place in the trajectory.
  std::vector<std::pair<std::size_t, std::shared_ptr<const MapFrame>>> waiting_;
};

}  // namespace framewise
