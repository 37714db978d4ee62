// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace framewise {

// What an inertial unit reads at one time.
struct ImuReading {
  double time;                     // s
  Eigen::Vector3d angular_rate;    // against the world, in the unit's axes (rad/s)
  Eigen::Vector3d specific_force;  // acceleration less gravity, in the unit's axes (m/s^2)
};

}  // namespace framewise
