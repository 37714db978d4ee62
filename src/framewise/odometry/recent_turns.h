// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <deque>
#include <utility>

namespace framewise {

// How a camera was turned in its last frames, and so how fast it turns: stamps jitter by more than cameras
// do, so that a rate is taken over some frames.
class RecentTurns {
 public:
  void add(double time, const Eigen::Matrix3d& world_from_cam);

  // rad/s, in the camera's axes, of a frame that is turned by cam_from_before against the newest one, which
  // was at time_before. Zero where it is not later than that.
  Eigen::Vector3d rate(const Eigen::Matrix3d& cam_from_before, const Eigen::Matrix3d& world_from_before,
                       double time_before, double time) const;

 private:
  std::deque<std::pair<double, Eigen::Matrix3d>> turns_;  // when, world_from_cam
};

}  // namespace framewise
