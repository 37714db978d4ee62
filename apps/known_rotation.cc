// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "known_rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "framewise/geometry/gyroscope.h"
#include "framewise/geometry/so3.h"
#include "framewise/io/gyroscope_file.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"

namespace framewise::apps {
namespace {

// By the columns of its first line of numbers: trajectories have 8 or more.
bool is_gyroscope_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
    if (!line.empty() && line[0] != '#')
      return std::count(line.begin(), line.end(), ',') + 1 < 8 && line.find(',') != line.npos;
  return false;
}

// Matrices in files are as good as their printed digits; a rotation is made of them here.
RotationSource of_poses(std::function<std::optional<Pose>(std::size_t)> world_from_cam) {
  return [world_from_cam](std::size_t i, std::size_t j) -> std::optional<Eigen::Matrix3d> {
    const auto pose1 = world_from_cam(i), pose2 = world_from_cam(j);
    if (!pose1 || !pose2) return std::nullopt;
    return nearest_rotation(pose2->R.transpose() * pose1->R);
  };
}

RotationSource of_gyroscope(std::shared_ptr<const Gyroscope> gyroscope, const Recording& recording,
                            double max_gap) {
  return [gyroscope, &recording, max_gap](std::size_t i, std::size_t j) {
    return rotation_between(*gyroscope, recording.times[i], recording.times[j], max_gap);
  };
}

RotationSource of_file(const std::filesystem::path& file, const Recording& recording, double max_gap) {
  if (is_gyroscope_file(file))
    return of_gyroscope(std::make_shared<Gyroscope>(read_gyroscope(file)), recording, max_gap);
  const TrajectoryFile read = read_trajectory(file);
  if (!read.has_times) throw InputError(file, 0, "", "poses without stamps", "a trajectory with stamps (s)");
  const auto trajectory = std::make_shared<Trajectory>(read.trajectory);
  return of_poses([trajectory, &recording, max_gap](std::size_t i) {
    return pose_at(*trajectory, recording.times[i], max_gap);
  });
}

RotationSource of_name(const std::string& choice, const Recording& recording, double max_gap) {
  if (choice == "truth") {
    if (!recording.has_truth())
      throw InputError(recording.path, 0, "rotation", "no truth", "one to take it from");
    return of_poses([&recording](std::size_t i) { return recording.truth[i]; });
  }
  if (choice != "gyro") return of_file(choice, recording, max_gap);
  if (!recording.images || recording.images->gyroscope.empty())
    throw InputError(recording.path, 0, "rotation", "no gyroscope", "a data set with one, or a file of one");
  return of_gyroscope(std::make_shared<Gyroscope>(recording.images->gyroscope), recording, max_gap);
}

}  // namespace

RotationSource rotation_source(const std::string& choice, const Recording& recording, double max_gap) {
  RotationSource source = of_name(choice, recording, max_gap);
  for (std::size_t i = 0; i + 1 < recording.size(); ++i)
    if (source(i, i + 1)) return source;
  if (recording.size() > 1)
    throw InputError(choice, 0, "rotation", "none between any two frames",
                     fmt::format("times from {} to {} s", recording.times.front(), recording.times.back()));
  return source;
}

}  // namespace framewise::apps
