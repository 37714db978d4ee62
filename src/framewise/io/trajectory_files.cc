// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/trajectory_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <vector>

#include "framewise/io/frame_times.h"
#include "framewise/io/input_error.h"
#include "framewise/io/number_rows.h"
#include "framewise/io/pose_rows.h"

namespace framewise {
namespace {

struct TimedPose {
  double time;
  Pose pose;
  double norm_error = 0;  // of its quaternion
};

TimedPose timed_pose(const NumberRows& rows, const NumberRow& row, double time, const Eigen::Vector3d& t,
                     const Eigen::Quaterniond& q) {
  return {time, pose_of_quaternion(rows, row, t, q), std::abs(q.norm() - 1)};
}

TimedPose tum_pose(const NumberRows& rows, const NumberRow& row) {
  static const std::array<std::string, 8> names = {"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  rows.expect_columns(row, row.fields.size() == 8, "8 (timestamp tx ty tz qx qy qz qw)");
  std::array<double, 8> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = rows.number(row, i, names[i]);
  return timed_pose(rows, row, v[0], {v[1], v[2], v[3]}, {v[7], v[4], v[5], v[6]});
}

TimedPose euroc_pose(const NumberRows& rows, const NumberRow& row) {
  static const std::array<std::string, 8> names = {"timestamp", "x", "y", "z", "qw", "qx", "qy", "qz"};
  rows.expect_columns(row, row.fields.size() >= 8, "8 or more (timestamp, x, y, z, qw, qx, qy, qz, ...)");
  std::array<double, 8> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = rows.number(row, i, names[i]);
  return timed_pose(rows, row, v[0] / 1e9, {v[1], v[2], v[3]}, {v[4], v[5], v[6], v[7]});
}

Pose kitti_pose(const NumberRows& rows, const NumberRow& row) {
  rows.expect_columns(row, row.fields.size() == 12, "12 (a 3x4 matrix, row by row)");
  return pose_of_matrix(rows, row);
}

TrajectoryFormat format_of(const NumberRows& rows, const NumberRow& row) {
  const std::size_t columns = row.fields.size();
  if (columns == 12 && !row.commas) return TrajectoryFormat::kKitti;
  const bool integer =
      std::all_of(row.fields[0].begin(), row.fields[0].end(), [](char c) { return c >= '0' && c <= '9'; });
  if (columns >= 8 && row.commas && integer) return TrajectoryFormat::kEuroc;
  rows.expect_columns(row, columns == 8,
                      "8 (TUM), 12 (KITTI) or, after nanoseconds and commas, 8 or more (EuRoC)");
  return TrajectoryFormat::kTum;
}

// Stamps since 1970, and steps between poses, betray their unit: seconds stay below 1e11 until the year 5138,
// and nobody waits three hours between two poses.
void expect_seconds(const std::filesystem::path& path, const Trajectory& trajectory, std::size_t line) {
  const double first = std::abs(trajectory.times.front());
  const char* unit = first >= 1e17   ? "nanoseconds"
                     : first >= 1e14 ? "microseconds"
                     : first >= 1e11 ? "milliseconds"
                                     : "";
  if (*unit != '\0')
    throw InputError(path, line, "timestamp",
                     shortest_text(trajectory.times.front()) + ", which looks like " + unit, "seconds");
  std::vector<double> steps = {0};
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    steps.push_back(trajectory.times[i] - trajectory.times[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
  const double step = steps[steps.size() / 2];
  if (step >= 1e4)
    throw InputError(path, 0, "timestamp",
                     "poses " + shortest_text(step) + " apart, which looks like " +
                         (step >= 1e6 ? "nanoseconds" : "microseconds"),
                     "seconds");
}

void append(const std::filesystem::path& path, std::size_t line, const TimedPose& timed,
            TrajectoryFile& file) {
  Trajectory& trajectory = file.trajectory;
  file.norm_error = std::max(file.norm_error, timed.norm_error);
  if (!trajectory.empty() && timed.time < trajectory.times.back())
    throw InputError(path, line, "timestamp",
                     shortest_text(timed.time) + " after " + shortest_text(trajectory.times.back()),
                     "stamps that increase (two runs in one file?)");
  if (!trajectory.empty() && timed.time == trajectory.times.back())
    ++file.repeated;
  else
    trajectory.add(timed.time, timed.pose);
}

void add_kitti(const NumberRows& rows, const std::filesystem::path& times_path, TrajectoryFile& file) {
  std::vector<double> times;
  if (!times_path.empty()) {
    times = read_times(times_path);
    if (times.size() != rows.size())
      throw InputError(times_path, 0, "stamps", std::to_string(times.size()),
                       std::to_string(rows.size()) + ", one for each pose of " + rows.path().string());
  }
  file.has_times = !times.empty();
  for (std::size_t i = 0; i < rows.size(); ++i)
    append(times_path, i + 1, {times.empty() ? static_cast<double>(i) : times[i], kitti_pose(rows, rows[i])},
           file);
}

}  // namespace

TrajectoryFile read_trajectory(const std::filesystem::path& path, std::optional<TrajectoryFormat> format,
                               const std::filesystem::path& times) {
  const NumberRows rows(path, "a trajectory");
  if (rows.empty()) throw InputError(path, 0, "", "no poses", "one or more lines of numbers");

  TrajectoryFile file;
  file.format = format.value_or(format_of(rows, rows[0]));
  if (file.format == TrajectoryFormat::kKitti) {
    add_kitti(rows, times, file);
  } else {
    for (const NumberRow& row : rows)
      append(path, row.line,
             file.format == TrajectoryFormat::kTum ? tum_pose(rows, row) : euroc_pose(rows, row), file);
  }
  if (file.has_times) expect_seconds(path, file.trajectory, rows[0].line);
  return file;
}

std::string tum_line(double time, const Pose& world_from_cam) {
  Eigen::Quaterniond q = world_from_cam.quaternion();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  std::array<char, 400> text;  // stamps without exponents, for the readers' sake
  std::string line(text.data(),
                   std::to_chars(text.data(), text.data() + text.size(), time, std::chars_format::fixed).ptr);
  const Eigen::Vector3d& t = world_from_cam.t;
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
    line.append(1, ' ').append(shortest_text(value + 0.0));  // no "-0"
  return line;
}

void write_tum_trajectory(const std::filesystem::path& path, const Trajectory& trajectory) {
  std::ofstream file(path, std::ios::binary);
  file << "# timestamp tx ty tz qx qy qz qw\n";
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    file << tum_line(trajectory.times[i], trajectory.world_from_cam[i]) << '\n';
  if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace framewise
