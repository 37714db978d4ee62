// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/kitti_segments.h"

#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

std::vector<float> distances(const Trajectory& trajectory) {
  std::vector<float> along(trajectory.size(), 0.0F);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const Eigen::Vector3f step =
        (trajectory.world_from_cam[i].t - trajectory.world_from_cam[i - 1].t).cast<float>();
    along[i] = along[i - 1] + std::sqrt(step.x() * step.x() + step.y() * step.y() + step.z() * step.z());
  }
  return along;
}

Pose motion_between(const Trajectory& trajectory, std::size_t i, std::size_t j) {
  return trajectory.world_from_cam[i].inverse() * trajectory.world_from_cam[j];
}

}  // namespace

SegmentErrors kitti_segment_errors(const TrajectoryPair& matched) {
  constexpr std::size_t every_nth = 10;
  const std::vector<float> along = distances(matched.reference);
  SegmentErrors errors;
  for (std::size_t first = 0; first < along.size(); first += every_nth)
    for (int length = 100; length <= 800; length += 100) {
      std::size_t last = first;
      while (last < along.size() && along[last] <= along[first] + static_cast<float>(length)) ++last;
      if (last == along.size()) break;
      const Pose E = motion_between(matched.estimate, first, last).inverse() *
                     motion_between(matched.reference, first, last);
      errors.segments.push_back(
          {first, static_cast<double>(length), E.t.norm() / length, rotation_angle(E.R) / length});
    }
  for (const SegmentError& e : errors.segments) {
    errors.translation_percent += 100 * e.translation / static_cast<double>(errors.segments.size());
    errors.rotation_deg_per_100m +=
        100 * e.rotation * 180 / M_PI / static_cast<double>(errors.segments.size());
  }
  return errors;
}

}  // namespace framewise
