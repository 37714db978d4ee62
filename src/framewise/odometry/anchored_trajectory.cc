// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/anchored_trajectory.h"

namespace framewise {

void AnchoredTrajectory::add(int keyframe, const Pose& world_from_cam, const LocalMap& map) {
  frames_.push_back({keyframe, map.at(keyframe).world_from_cam.inverse() * world_from_cam});
}

void AnchoredTrajectory::replace(std::size_t index, int keyframe, const Pose& world_from_cam,
                                 const LocalMap& map) {
  frames_[index] = {keyframe, map.at(keyframe).world_from_cam.inverse() * world_from_cam};
}

Pose AnchoredTrajectory::pose(std::size_t index, const LocalMap& map) const {
  return map.last_pose_of(frames_[index].keyframe) * frames_[index].keyframe_from_cam;
}

std::vector<Pose> AnchoredTrajectory::poses(const LocalMap& map) const {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < frames_.size(); ++i) poses.push_back(pose(i, map));
  return poses;
}

}  // namespace framewise
