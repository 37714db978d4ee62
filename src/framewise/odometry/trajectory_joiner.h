// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "framewise/odometry/step.h"

namespace framewise {

// Joins steps between neighbours into a trajectory, and goes on after a loss: the last frame whose pose was
// measured stays the reference for max_bridge seconds, so that a short loss costs no drift.
class TrajectoryJoiner {
 public:
  // Relates a frame to the reference: called only where the step from the frame before does not serve.
  using Relate = std::function<Step(std::size_t reference_index)>;

  struct Joined {
    Step step;
    Pose world_from_cam;
  };

  explicit TrajectoryJoiner(double max_bridge) : max_bridge_(max_bridge) {}

  // The first frame's time (s); the world is its camera.
  Joined start(double time);

  // The next frame's time, its step from the frame directly before it, and how to relate it to an older
  // reference.
  Joined add(double time, const Step& from_previous, const Relate& relate);

  // Of the last frame with a measured pose, counted from 0.
  std::size_t reference_index() const { return reference_index_; }

 private:
  void refer_to(double time, const Pose& world_from_cam);

  double max_bridge_;
  std::size_t index_ = 0;  // of the newest frame
  std::size_t reference_index_ = 0;
  double reference_time_ = 0;
  Pose world_from_reference_;
};

}  // namespace framewise
