// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/kitti_segments.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// Length of a double vector, in the devkit's arithmetic.
float float_length(const Eigen::Vector3d& v) {
  const Eigen::Vector3f f = v.cast<float>();
  return std::sqrt(f.x() * f.x() + f.y() * f.y() + f.z() * f.z());
}

// Angle of a rotation, in the devkit's arithmetic.
float float_angle(const Eigen::Matrix3d& R) {
  const Eigen::Vector3f diagonal = R.diagonal().cast<float>();
  const float cosine = 0.5F * (diagonal[0] + diagonal[1] + diagonal[2] - 1.0F);
  return std::acos(std::max(std::min(cosine, 1.0F), -1.0F));
}

std::vector<float> distances(const Trajectory& trajectory) {
  const auto& poses = trajectory.world_from_cam;
  std::vector<float> along(trajectory.size(), 0.0F);
  for (std::size_t i = 1; i < poses.size(); ++i)
    along[i] = along[i - 1] + float_length(poses[i].t - poses[i - 1].t);
  return along;
}

// With an inverse, not a transpose: matrices of files are rotations to their printed digits only, and the
// float above sees the difference.
Eigen::Matrix4d motion_between(const Trajectory& trajectory, std::size_t i, std::size_t j) {
  return trajectory.world_from_cam[i].matrix().inverse() * trajectory.world_from_cam[j].matrix();
}

SegmentError segment_error(const TrajectoryPair& matched, std::size_t first, std::size_t last, int length) {
  const Eigen::Matrix4d E = motion_between(matched.estimate, first, last).inverse() *
                            motion_between(matched.reference, first, last);
  const Eigen::Matrix3d R = E.topLeftCorner<3, 3>();
  const float metres = static_cast<float>(length);
  return {first, static_cast<double>(length), float_length(E.topRightCorner<3, 1>()) / metres,
          float_angle(R) / metres, rotation_angle(R) / length};
}

}  // namespace

SegmentErrors kitti_segment_errors(const TrajectoryPair& matched) {
  constexpr std::size_t every_nth = 10;
  const std::vector<float> along = distances(matched.reference);
  SegmentErrors errors;
  for (std::size_t first = 0; first < along.size(); first += every_nth)
    for (int length = 100; length <= 800; length += 100) {
      const float mark = along[first] + static_cast<float>(length);
      const auto last =
          std::upper_bound(along.begin() + static_cast<std::ptrdiff_t>(first), along.end(), mark);
      if (last == along.end()) break;
      errors.segments.push_back(
          segment_error(matched, first, static_cast<std::size_t>(last - along.begin()), length));
    }
  const double n = static_cast<double>(errors.segments.size()), deg_per_100m = 100 * 180 / M_PI;
  for (const SegmentError& e : errors.segments) {
    errors.translation_percent += 100 * e.translation / n;
    errors.rotation_deg_per_100m += deg_per_100m * e.rotation / n;
    errors.exact_rotation_deg_per_100m += deg_per_100m * e.exact_rotation / n;
  }
  return errors;
}

}  // namespace framewise
