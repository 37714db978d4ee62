// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "framewise/geometry/pose.h"

namespace framewise {

// How far a measured pose was taken (1: wholly) and the mean square of its innovation (per axis), of the
// rotation and of the position.
struct PriorDraw {
  double rotation = 1, position = 1;
  double rotation_innovation = 0, position_innovation = 0;
};

// How a camera goes on: it keeps turning about its own axes and moving through the world as it did, and how
// far it departs from that is learned from how far it did. What a measured pose says is taken as far as it is
// more certain than that: where the step is below what the data can tell, the camera goes on as before, and
// one that stands, stands.
//   The alpha-beta filter: Kalata, The tracking index, IEEE T-AES 1984; with the size of the manoeuvres from
//   the innovations, S = E[e^2] = R / (1 - alpha): Mehra, Approaches to adaptive filtering, IEEE T-AC 1972.
// The noise R may be more than was said where what was measured swings: noise n of poses gives their second
// differences a product of -4 n^2 with the ones before, a motion that changes by and by gives them more than
// 0.
class MotionFilter {
 public:
  explicit MotionFilter(bool shrinks) : shrinks_(shrinks) {}

  // Begins at a pose, standing.
  void start(double time, const Pose& world_from_cam);

  // Where the camera is expected at a time (s).
  Pose predict(double time) const;

  // Takes a measured pose in and gives the pose that is believed. covariance: of world_from_cam, rotation in
  // the camera's axes and position in the world's. Without shrinking this is the measured pose.
  Pose update(double time, const Pose& world_from_cam, const Matrix6d& covariance);

  const PriorDraw& draw() const { return draw_; }  // of the last update

  // No pose was measured: the camera goes on as it did, and slower and slower, the sooner the less its motion
  // before was like itself half a second later: hands change their minds, vehicles seldom do.
  void coast(double time);

  // Poses of the map have moved: of the newest pose, from what was believed to what is believed now.
  void correct(const Pose& new_from_old);

  // How far a camera departs from its prediction in a frame, as it did so far: covariance as in update. The
  // identity where nothing is known of it.
  Matrix6d departure() const;

  // cam2_from_cam1 of a camera that is now and was or will be `delay` seconds later.
  Pose motion_during(double delay) const;

 private:
  // Rotation or position: three numbers with one noise.
  struct Axes {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    double innovation = -1;  // its mean square (per axis); negative: none yet
    double taken = 1;        // of the last innovation
    Eigen::Vector3d update(const Eigen::Vector3d& e, double noise, double dt, bool shrinks);

    // The motion that was measured from frame to frame: its rate, how that changed, and the mean product (per
    // axis) of a change and the one before.
    Eigen::Vector3d rate = Eigen::Vector3d::Zero(), change = Eigen::Vector3d::Zero();
    double change_products = 0;
    int rates = 0;
    void take_rate(const Eigen::Vector3d& measured_rate, double dt);
    double shown_noise(double said) const;  // variance

    // Velocities a lag apart, their products and squares: how much of one is left in the next.
    Eigen::Vector3d velocity_then = Eigen::Vector3d::Zero();
    double products = 0, squares = 0;
    void compare_with_then();
    double share_kept(double seconds) const;
  };

  bool shrinks_;
  double time_ = 0;
  Pose world_from_cam_, measured_;  // as believed, and as it was measured
  Axes rotation_, position_;
  double time_then_ = std::numeric_limits<double>::quiet_NaN();  // of velocity_then
  int updates_ = 0;
  PriorDraw draw_;
};

}  // namespace framewise
