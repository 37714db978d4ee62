// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/trajectory_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

using Fields = std::vector<std::string_view>;

// One line of numbers, still text, with its place in the file.
struct Row {
  std::size_t line;
  Fields fields;
  bool commas;
};

std::string quoted(std::string_view text) { return "'" + std::string(text.substr(0, 40)) + "'"; }

std::string shortest(double value) {
  std::array<char, 400> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

Fields split(std::string_view line) {
  constexpr std::string_view separators = " \t,;\v\f";
  Fields fields;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return fields;
}

std::string read_text(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) throw InputError(path.string(), 0, "", "a folder", "a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path.string(), 0, "", "no such file, or none that can be read", "a trajectory");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Row> rows_of(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // byte order mark of some editors
  std::vector<Row> rows;
  for (std::size_t begin = 0, line = 1; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string_view content = text.substr(begin, end - begin);
    content = content.substr(0, content.find('#'));
    Fields fields = split(content);
    if (!fields.empty())
      rows.push_back({line, std::move(fields), content.find(',') != std::string_view::npos});
    begin = text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
  }
  return rows;
}

double number(const std::string& path, const Row& row, std::size_t column, const std::string& name) {
  std::string_view field = row.fields[column];
  if (field.size() > 1 && field[0] == '+') field.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size())
    throw InputError(path, row.line, name, quoted(row.fields[column]), "a number");
  if (!std::isfinite(value))
    throw InputError(path, row.line, name, quoted(row.fields[column]), "a finite number");
  return value;
}

void expect_columns(const std::string& path, const Row& row, bool right, const std::string& expected) {
  if (!right) throw InputError(path, row.line, "columns", std::to_string(row.fields.size()), expected);
}

Pose pose_of_quaternion(const std::string& path, const Row& row, const Eigen::Vector3d& t,
                        const Eigen::Quaterniond& q) {
  if (!(q.norm() > 1e-3) || !(q.norm() < 1e3))
    throw InputError(path, row.line, "quaternion", "length " + shortest(q.norm()), "a length near 1");
  return Pose::from_quaternion(q, t);
}

struct TimedPose {
  double time;
  Pose pose;
};

TimedPose tum_pose(const std::string& path, const Row& row) {
  static const std::array<std::string, 8> names = {"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  expect_columns(path, row, row.fields.size() == 8, "8 (timestamp tx ty tz qx qy qz qw)");
  std::array<double, 8> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = number(path, row, i, names[i]);
  return {v[0], pose_of_quaternion(path, row, {v[1], v[2], v[3]}, {v[7], v[4], v[5], v[6]})};
}

TimedPose euroc_pose(const std::string& path, const Row& row) {
  static const std::array<std::string, 8> names = {"timestamp", "x", "y", "z", "qw", "qx", "qy", "qz"};
  expect_columns(path, row, row.fields.size() >= 8, "8 or more (timestamp, x, y, z, qw, qx, qy, qz, ...)");
  std::array<double, 8> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = number(path, row, i, names[i]);
  return {v[0] / 1e9, pose_of_quaternion(path, row, {v[1], v[2], v[3]}, {v[4], v[5], v[6], v[7]})};
}

// The matrix as printed: making it a better rotation would move what other tools measure in the last digits.
Pose kitti_pose(const std::string& path, const Row& row) {
  expect_columns(path, row, row.fields.size() == 12, "12 (a 3x4 matrix, row by row)");
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> M;
  for (std::size_t i = 0; i < 12; ++i) M.data()[i] = number(path, row, i, "column " + std::to_string(i + 1));
  const Eigen::Matrix3d R = M.leftCols<3>();
  if (!(R * R.transpose()).isIdentity(1e-3) || R.determinant() < 0)
    throw InputError(path, row.line, "rotation",
                     "R R' away from the identity by " +
                         shortest((R * R.transpose() - Eigen::Matrix3d::Identity()).norm()) +
                         " with determinant " + shortest(R.determinant()),
                     "a rotation matrix");
  return {R, M.col(3)};
}

TrajectoryFormat format_of(const std::string& path, const Row& row) {
  const std::size_t columns = row.fields.size();
  if (columns == 12 && !row.commas) return TrajectoryFormat::kKitti;
  const bool integer =
      std::all_of(row.fields[0].begin(), row.fields[0].end(), [](char c) { return c >= '0' && c <= '9'; });
  if (columns >= 8 && row.commas && integer) return TrajectoryFormat::kEuroc;
  expect_columns(path, row, columns == 8,
                 "8 (TUM), 12 (KITTI) or, after nanoseconds and commas, 8 or more (EuRoC)");
  return TrajectoryFormat::kTum;
}

// Stamps since 1970, and steps between poses, betray their unit: seconds stay below 1e11 until the year 5138,
// and nobody waits three hours between two poses.
void expect_seconds(const std::string& path, const Trajectory& trajectory, std::size_t line) {
  const double first = std::abs(trajectory.times.front());
  const char* unit = first >= 1e17   ? "nanoseconds"
                     : first >= 1e14 ? "microseconds"
                     : first >= 1e11 ? "milliseconds"
                                     : "";
  if (*unit != '\0')
    throw InputError(path, line, "timestamp",
                     shortest(trajectory.times.front()) + ", which looks like " + unit, "seconds");
  std::vector<double> steps = {0};
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    steps.push_back(trajectory.times[i] - trajectory.times[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
  const double step = steps[steps.size() / 2];
  if (step >= 1e4)
    throw InputError(path, 0, "timestamp",
                     "poses " + shortest(step) + " apart, which looks like " +
                         (step >= 1e6 ? "nanoseconds" : "microseconds"),
                     "seconds");
}

void append(const std::string& path, std::size_t line, const TimedPose& timed, TrajectoryFile& file) {
  Trajectory& trajectory = file.trajectory;
  if (!trajectory.empty() && timed.time < trajectory.times.back())
    throw InputError(path, line, "timestamp",
                     shortest(timed.time) + " after " + shortest(trajectory.times.back()),
                     "stamps that increase (two runs in one file?)");
  if (!trajectory.empty() && timed.time == trajectory.times.back())
    ++file.repeated;
  else
    trajectory.add(timed.time, timed.pose);
}

std::vector<double> read_times(const std::filesystem::path& path) {
  std::vector<double> times;
  const std::string text = read_text(path);  // the rows point into it
  for (const Row& row : rows_of(text)) {
    expect_columns(path.string(), row, row.fields.size() == 1, "1 (a stamp in seconds)");
    times.push_back(number(path.string(), row, 0, "timestamp"));
  }
  return times;
}

void add_kitti(const std::string& path, const std::vector<Row>& rows, const std::filesystem::path& times_path,
               TrajectoryFile& file) {
  std::vector<double> times;
  if (!times_path.empty()) {
    times = read_times(times_path);
    if (times.size() != rows.size())
      throw InputError(times_path.string(), 0, "stamps", std::to_string(times.size()),
                       std::to_string(rows.size()) + ", one for each pose of " + path);
  }
  file.has_times = !times.empty();
  for (std::size_t i = 0; i < rows.size(); ++i)
    append(times_path.string(), i + 1,
           {times.empty() ? static_cast<double>(i) : times[i], kitti_pose(path, rows[i])}, file);
}

}  // namespace

TrajectoryFile read_trajectory(const std::filesystem::path& path, std::optional<TrajectoryFormat> format,
                               const std::filesystem::path& times) {
  const std::string name = path.string();
  const std::string text = read_text(path);
  const std::vector<Row> rows = rows_of(text);
  if (rows.empty()) throw InputError(name, 0, "", "no poses", "one or more lines of numbers");

  TrajectoryFile file;
  file.format = format.value_or(format_of(name, rows[0]));
  if (file.format == TrajectoryFormat::kKitti) {
    add_kitti(name, rows, times, file);
  } else {
    for (const Row& row : rows)
      append(name, row.line,
             file.format == TrajectoryFormat::kTum ? tum_pose(name, row) : euroc_pose(name, row), file);
  }
  if (file.has_times) expect_seconds(name, file.trajectory, rows[0].line);
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
    line.append(1, ' ').append(shortest(value + 0.0));  // no "-0"
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
