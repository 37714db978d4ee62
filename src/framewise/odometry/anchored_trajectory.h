// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/odometry/local_map.h"

namespace framewise {

// All frames, each by the keyframe it is told by: where that moves, they move with it.
class AnchoredTrajectory {
 public:
  // A keyframe that the map holds.
  void add(int keyframe, const Pose& world_from_cam, const LocalMap& map);
  // Tells a frame that was added, by its index, otherwise.
  void replace(std::size_t index, int keyframe, const Pose& world_from_cam, const LocalMap& map);

  std::size_t size() const { return frames_.size(); }
  // world_from_cam as the keyframes are, or ended.
  Pose pose(std::size_t index, const LocalMap& map) const;
  std::vector<Pose> poses(const LocalMap& map) const;

 private:
  struct Anchored {
    int keyframe;
    Pose keyframe_from_cam;
  };
  std::vector<Anchored> frames_;
};

}  // namespace framewise
