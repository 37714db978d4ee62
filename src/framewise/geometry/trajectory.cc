// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/trajectory.h"

#include <algorithm>

namespace framewise {

double path_length(const Trajectory& trajectory) {
  double length = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    length += (trajectory.world_from_cam[i].t - trajectory.world_from_cam[i - 1].t).norm();
  return length;
}

std::optional<Pose> pose_at(const Trajectory& trajectory, double time, double max_gap) {
  const auto& times = trajectory.times;
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.end()) return std::nullopt;
  const std::size_t i = after - times.begin();
  if (*after == time) return trajectory.world_from_cam[i];
  if (i == 0 || times[i] - times[i - 1] > max_gap) return std::nullopt;
  const double s = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return interpolate(trajectory.world_from_cam[i - 1], trajectory.world_from_cam[i], s);
}

}  // namespace framewise
