// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <vector>

#include "framewise/geometry/place_noise.h"
#include "framewise/geometry/pose.h"
#include "framewise/odometry/map_frame.h"
#include "framewise/odometry/rolling_shutter.h"

namespace framewise {

// A keyframe's view of a point that another keyframe hosts.
struct PointView {
  int keyframe;
  Eigen::Vector3d ray;   // on the plane z = 1, in the axes of the image's middle row
  PlaceNoise noise;      // of the ray
  double z;              // measured depth (m); NaN where unknown
  Eigen::Vector3d seen;  // the ray in the axes of its own row
  double row;            // of the image (rolling_shutter.h)
};

// A point is a pixel of the keyframe that hosts it, and its inverse depth there: what is uncertain is one
// number, and it is nearly Gaussian.
//   Civera, Davison, Montiel, Inverse depth parametrization for monocular SLAM, T-RO 2008.
struct MapPoint {
  int feature;             // of the host
  Eigen::Vector3d ray;     // in the host, on the plane z = 1
  double inverse_z;        // 1/m
  double variance;         // of inverse_z
  double measured = 0;     // inverse_z as depth images alone have it, and its information; 0 where none has
  double information = 0;  // (m^2)
  std::vector<PointView> views;
  int sought = 0, found = 0;  // in how many frames, while its depth was not known
  bool is_given_up = false;   // it was not what it was taken for
  // Of the surface around: d inverse_z / d ray (1/m); 0: across the line of sight.
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();

  // Else it is a direction and a guess of how far that reaches.
  bool is_known() const {
    constexpr double kMostRelativeSigma = 0.3;
    return std::sqrt(variance) < kMostRelativeSigma * inverse_z;
  }

  Eigen::Vector3d position() const { return ray / inverse_z; }  // in the host
  // Its covariance there: along the ray alone.
  Eigen::Matrix3d covariance() const {
    const double z2 = 1 / (inverse_z * inverse_z);
    return (variance * z2 * z2) * ray * ray.transpose();
  }
};

struct Keyframe {
  int id = 0;
  std::shared_ptr<const MapFrame> frame;
  Pose world_from_cam;
  std::vector<MapPoint> points;  // that it hosts
  Shutter shutter;               // as it turned
};

struct PointRef {
  int keyframe, point;
};

// The last keyframes and their points.
class LocalMap {
 public:
  explicit LocalMap(int capacity) : capacity_(capacity) {}

  // The newest; the oldest goes where there are too many. Ids count up from 0.
  Keyframe& add(std::shared_ptr<const MapFrame> frame, const Pose& world_from_cam);

  bool empty() const { return keyframes_.empty(); }
  bool holds(int id) const { return id >= first_id() && id < next_id_; }
  int first_id() const { return next_id_ - static_cast<int>(keyframes_.size()); }
  int newest_id() const { return next_id_ - 1; }
  Keyframe& at(int id) { return keyframes_[id - first_id()]; }
  const Keyframe& at(int id) const { return keyframes_[id - first_id()]; }
  const Keyframe& newest() const { return keyframes_.back(); }
  MapPoint& point(const PointRef& ref) { return at(ref.keyframe).points[ref.point]; }
  const MapPoint& point(const PointRef& ref) const { return at(ref.keyframe).points[ref.point]; }

  // Forgets all of them and goes on as another map, whose world stands so in this one's.
  void go_on_as(const LocalMap& other, const Pose& world_from_other);

  // Makes all rays anew for a camera that turned out to be another one.
  void set_camera(const Camera& from, const Camera& to);
  // Turns all rays to the middle rows anew.
  void set_readout(double readout, const Camera& camera);

  // Where keyframes ended that are gone, or are.
  const Pose& last_pose_of(int id) const { return holds(id) ? at(id).world_from_cam : gone_[id]; }

 private:
  void forget_oldest();

  int capacity_;
  int next_id_ = 0;
  std::deque<Keyframe> keyframes_;
  std::vector<Pose> gone_;
};

// A point where a camera would see it.
struct VisiblePoint {
  PointRef ref;
  Eigen::Vector2d pixel;
  Eigen::Vector3d x_in_cam;
  double spread_px = 0;  // how far off it may be for want of its depth, of a point that is not known
};

// Keyframes to track against from a pose: the newest ones, and of the others those whose points are most in
// view, so that what is seen again is known again. Oldest first.
std::vector<int> keyframes_in_view(const LocalMap& map, const Pose& world_from_cam, const Camera& camera,
                                   int newest, int others);

// The points of some keyframes that a camera would see in its image and from a similar side and distance.
std::vector<VisiblePoint> points_in_view(const LocalMap& map, const std::vector<int>& keyframes,
                                         const Pose& world_from_cam, const Camera& camera,
                                         const Shutter& shutter);

// Those that are so near to where they are expected that a search there finds them.
std::vector<VisiblePoint> settled(const std::vector<VisiblePoint>& points, double max_spread_px);

}  // namespace framewise
