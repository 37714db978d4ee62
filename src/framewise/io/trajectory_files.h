// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framewise/geometry/trajectory.h"

namespace framewise {

enum class TrajectoryFormat {
  kTum,    // t tx ty tz qx qy qz qw, seconds
  kKitti,  // 12 numbers, the 3x4 matrix row by row; stamps in a file of their own or none
  kEuroc,  // ns, x, y, z, qw, qx, qy, qz, ... separated by commas
};

struct TrajectoryFile {
  Trajectory trajectory;  // world_from_cam; of EuRoC world_from_body, as the file has it
  TrajectoryFormat format = TrajectoryFormat::kTum;
  bool has_times = true;  // false: KITTI without stamps; times are then 0, 1, 2, ... (frames, not seconds)
  std::size_t repeated =
      0;                  // poses left out since their stamp is that of the one before (motion capture does)
  double norm_error = 0;  // largest distance of a quaternion's length from 1, before it was made 1
};

// Reads a trajectory; without a format, the first line of numbers tells it: 12 columns are KITTI, 8 or more
// that begin with an integer of nanoseconds and are separated by commas are EuRoC, 8 are TUM. '#' begins a
// comment; blanks, tabs, commas, and line ends of any system separate. `times`, for KITTI: one stamp (s) a
// line. Throws InputError for a file that is missing or has no poses, a column count or a number that is
// wrong, NaN, a quaternion without length, a matrix that is no rotation, stamps that go back, and
// stamps that are not seconds.
TrajectoryFile read_trajectory(const std::filesystem::path& path,
                               std::optional<TrajectoryFormat> format = std::nullopt,
                               const std::filesystem::path& times = {});

// The line of a TUM file for one pose, without its end; every number in as few digits as bring it back
// exactly, qw not negative.
std::string tum_line(double time, const Pose& world_from_cam);

// Writes all of it, under one comment line that names the columns. Throws std::runtime_error when the file
// cannot be written.
void write_tum_trajectory(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace framewise
