// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/varying.h"

namespace framewise {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

// Level: looks along x of the world.
Eigen::Matrix3d world_from_level() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return R;
}

}  // namespace

Eigen::Matrix3d look(double heading, double pitch, double roll) {
  return (AngleAxisd(heading, Vector3d::UnitZ()) * AngleAxisd(-pitch, Vector3d::UnitY())).toRotationMatrix() *
         world_from_level() * AngleAxisd(roll, Vector3d::UnitZ()).toRotationMatrix();
}

Motion motion_of(const Varying (&position)[3], const Varying& heading, const Varying& pitch,
                 const Varying& roll) {
  Motion motion;
  motion.world_from_cam.R = look(heading.value, pitch.value, roll.value);
  for (int k = 0; k < 3; ++k) {
    motion.world_from_cam.t[k] = position[k].value;
    motion.velocity[k] = position[k].rate;
    motion.acceleration[k] = position[k].acceleration;
  }
  // Rates add along the chain of turns, each seen in the axes after it.
  const Vector3d turned_up = AngleAxisd(pitch.value, Vector3d::UnitY()) * Vector3d(0, 0, heading.rate);
  const Vector3d of_level = world_from_level().transpose() * (turned_up - Vector3d(0, pitch.rate, 0));
  motion.angular_rate = AngleAxisd(-roll.value, Vector3d::UnitZ()) * of_level + Vector3d(0, 0, roll.rate);
  return motion;
}

}  // namespace framewise
