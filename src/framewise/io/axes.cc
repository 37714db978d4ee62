// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/axes.h"

namespace framewise {

Pose mirrored_in_y(const Pose& world_from_cam) {
  const Eigen::DiagonalMatrix<double, 3> S(1, -1, 1);
  return {S * world_from_cam.R * S, S * world_from_cam.t};
}

Pose from_blender_camera(const Pose& world_from_blender_cam) {
  return {world_from_blender_cam.R * Eigen::DiagonalMatrix<double, 3>(1, -1, -1), world_from_blender_cam.t};
}

Eigen::Matrix3d rotation_of_euler_xyz(const Eigen::Vector3d& angles) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return (AngleAxisd(angles.z(), Vector3d::UnitZ()) * AngleAxisd(angles.y(), Vector3d::UnitY()) *
          AngleAxisd(angles.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace framewise
