// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "framewise/geometry/gyroscope.h"

namespace framewise {

// Reads the rates of an inertial unit as EuRoC's imu0/data.csv has them, four or seven columns:
//   #timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],a_RS_S_x [m s^-2],...
// The accelerations are left out; cam_from_gyro is the identity. Throws InputError for a file that is missing
// or has no rates, a column count or a number that is wrong, stamps that are no nanoseconds (whole numbers,
// and not a second or more apart as a rule) or do not increase, and rates that are none (above 100 rad/s).
Gyroscope read_gyroscope(const std::filesystem::path& path);

}  // namespace framewise
