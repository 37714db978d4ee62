// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "framewise/geometry/pose.h"

namespace framewise {

// Poses of one body over time: world_from_cam[i] at times[i] (s), times strictly increasing.
struct Trajectory {
  std::vector<double> times;
  std::vector<Pose> world_from_cam;

  std::size_t size() const { return times.size(); }
  bool empty() const { return times.empty(); }
  void add(double time, const Pose& pose) {
    times.push_back(time);
    world_from_cam.push_back(pose);
  }
};

// Sum of the distances between successive positions (m).
double path_length(const Trajectory& trajectory);

// The pose at a time, between its two neighbours (linear and slerp). Empty outside the trajectory, and where
// the neighbours are more than max_gap apart (s): a hole in the truth is no truth.
std::optional<Pose> pose_at(const Trajectory& trajectory, double time, double max_gap);

}  // namespace framewise
