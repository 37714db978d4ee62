// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/recent_turns.h"

#include "framewise/geometry/so3.h"

namespace framewise {

void RecentTurns::add(double time, const Eigen::Matrix3d& world_from_cam) {
  constexpr std::size_t kTurns = 3;
  turns_.emplace_back(time, world_from_cam);
  if (turns_.size() > kTurns) turns_.pop_front();
}

Eigen::Vector3d RecentTurns::rate(const Eigen::Matrix3d& cam_from_before,
                                  const Eigen::Matrix3d& world_from_before, double time_before,
                                  double time) const {
  const double dt = time - time_before;
  if (!(dt > 0)) return Eigen::Vector3d::Zero();
  if (turns_.empty() || !(time > turns_.front().first)) return so3_log(cam_from_before.transpose()) / dt;
  const Eigen::Matrix3d world_from_cam = world_from_before * cam_from_before.transpose();
  return so3_log(turns_.front().second.transpose() * world_from_cam) / (time - turns_.front().first);
}

}  // namespace framewise
