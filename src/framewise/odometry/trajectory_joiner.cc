// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/trajectory_joiner.h"

namespace framewise {

TrajectoryJoiner::Joined TrajectoryJoiner::start(double time) {
  index_ = 0;
  refer_to(time, Pose());
  Step step;
  step.status = Status::kOk;
  return {step, world_from_reference_};
}

TrajectoryJoiner::Joined TrajectoryJoiner::add(double time, const Step& from_previous, const Relate& relate) {
  const bool previous_is_reference = reference_index_ == index_;
  ++index_;
  const double reference_age = time - reference_time_;
  Step step = from_previous;
  if (!previous_is_reference && reference_age <= max_bridge_) step = relate(reference_index_);
  // A reference that is too old is given up: go on from the frame before, at the pose that was last known.
  if (is_measured(step.status)) refer_to(time, world_from_reference_ * step.cam2_from_cam1.inverse());
  return {step, world_from_reference_};
}

void TrajectoryJoiner::refer_to(double time, const Pose& world_from_cam) {
  reference_time_ = time;
  reference_index_ = index_;
  // Thousands of products round the rotation away from orthogonality unless it is renewed.
  world_from_reference_ = Pose::from_quaternion(world_from_cam.quaternion(), world_from_cam.t);
}

}  // namespace framewise
