// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/blender_path.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framewise/io/axes.h"
#include "framewise/io/file_names.h"
#include "framewise/io/input_error.h"
#include "framewise/io/pose_rows.h"

namespace framewise {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr double kRadians = M_PI / 180;

void add_pose(const fs::path& path, std::size_t line, long frame, const Pose& pose, BlenderPath& answer) {
  if (!answer.world_from_cam.emplace(frame, from_blender_camera(pose)).second)
    throw InputError(path, line, "frame", fmt::format("{} again", frame), "each frame once");
}

// Which column holds what.
class Columns {
 public:
  Columns(const NumberRows& rows, const NumberRow& header) : rows_(rows) {
    for (std::size_t i = 0; i < header.fields.size(); ++i)
      column_.emplace(lower_case(std::string(header.fields[i])), i);
  }

  bool has(const std::string& name) const { return column_.contains(name); }

  double number(const NumberRow& row, const std::string& name) const {
    const auto found = column_.find(name);
    if (found == column_.end())
      throw InputError(rows_.path(), rows_[0].line, "columns", "no column '" + name + "'",
                       "frame, x, y, z and qw, qx, qy, qz or rx, ry, rz or rx_deg, ry_deg, rz_deg");
    rows_.expect_columns(row, row.fields.size() == column_.size(), std::to_string(column_.size()));
    return rows_.number(row, found->second, name);
  }

  Eigen::Vector3d vector(const NumberRow& row, const std::array<const char*, 3>& names) const {
    return {number(row, names[0]), number(row, names[1]), number(row, names[2])};
  }

 private:
  const NumberRows& rows_;
  std::map<std::string, std::size_t> column_;
};

Pose pose_of_row(const NumberRows& rows, const Columns& columns, const NumberRow& row) {
  const Eigen::Vector3d t = columns.vector(row, {"x", "y", "z"});
  if (columns.has("qw")) {
    const Eigen::Vector3d v = columns.vector(row, {"qx", "qy", "qz"});
    return pose_of_quaternion(rows, row, t, {columns.number(row, "qw"), v.x(), v.y(), v.z()});
  }
  const Eigen::Vector3d angles = columns.has("rx_deg")
                                     ? columns.vector(row, {"rx_deg", "ry_deg", "rz_deg"}) * kRadians
                                     : columns.vector(row, {"rx", "ry", "rz"});
  return {rotation_of_euler_xyz(angles), t};
}

long frame_of_row(const NumberRows& rows, const Columns& columns, const NumberRow& row) {
  const double frame = columns.number(row, "frame");
  if (frame != std::floor(frame) || std::abs(frame) > 1e9)
    throw InputError(rows.path(), row.line, "frame", shortest_text(frame), "a whole number");
  return static_cast<long>(frame);
}

BlenderPath read_table(const fs::path& path) {
  const NumberRows rows(path, "a camera path of Blender");
  if (rows.size() < 2)
    throw InputError(path, 0, "", fmt::format("{} lines", rows.size()),
                     "the columns' names and a line a frame");
  const Columns columns(rows, rows[0]);
  BlenderPath answer;
  for (std::size_t i = 1; i < rows.size(); ++i)
    add_pose(path, rows[i].line, frame_of_row(rows, columns, rows[i]), pose_of_row(rows, columns, rows[i]),
             answer);
  return answer;
}

// One frame of the JSON file, with its place for messages.
struct JsonFrame {
  const fs::path& path;
  const Json& json;
  std::size_t index;

  [[noreturn]] void refuse(const std::string& field, const std::string& expected) const {
    throw InputError(path, 0, fmt::format("frames[{}].{}", index, field),
                     json.contains(field) ? json[field].dump().substr(0, 60) : "nothing", expected);
  }

  template <std::size_t N>
  std::array<double, N> numbers(const char* field) const {
    try {
      return json.at(field).get<std::array<double, N>>();
    } catch (const Json::exception&) {
      refuse(field, fmt::format("{} numbers", N));
    }
  }

  Pose matrix(const char* field) const {
    Eigen::Matrix4d M;
    try {
      const auto rows = json.at(field).get<std::array<std::array<double, 4>, 4>>();
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) M(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    } catch (const Json::exception&) {
      refuse(field, "4 rows of 4 numbers");
    }
    const Pose pose{M.topLeftCorner<3, 3>(), M.topRightCorner<3, 1>()};
    expect_rotation(path, 0, pose.R);
    return pose;
  }

  Pose pose() const {
    for (const char* field : {"matrix_world", "transform_matrix"})
      if (json.contains(field)) return matrix(field);
    const auto [x, y, z] = numbers<3>("location");
    if (json.contains("rotation_quaternion")) {
      const auto [qw, qx, qy, qz] = numbers<4>("rotation_quaternion");
      const Eigen::Quaterniond q(qw, qx, qy, qz);
      if (!(q.norm() > 1e-3)) refuse("rotation_quaternion", "a length near 1");
      return Pose::from_quaternion(q, {x, y, z});
    }
    const auto [rx, ry, rz] = numbers<3>("rotation_euler");
    return {rotation_of_euler_xyz({rx, ry, rz}), {x, y, z}};
  }

  long number() const {
    if (json.contains("frame") && json["frame"].is_number_integer()) return json["frame"].get<long>();
    if (json.contains("file_path") && json["file_path"].is_string())
      if (const auto number = number_in(json["file_path"].get<std::string>())) return *number;
    refuse("frame", "a whole number");
  }
};

std::optional<double> number_of(const fs::path& path, const Json& json,
                                std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (!json.contains(name)) continue;
    if (json[name].is_number()) return json[name].get<double>();
    throw InputError(path, 0, name, json[name].dump().substr(0, 60), "a number");
  }
  return std::nullopt;
}

std::optional<Camera> camera_of(const fs::path& path, const Json& json) {
  const auto width = number_of(path, json, {"width", "w"}), height = number_of(path, json, {"height", "h"});
  const auto lens = number_of(path, json, {"lens"}), sensor = number_of(path, json, {"sensor_width"}),
             angle = number_of(path, json, {"camera_angle_x"});
  if (!width || !height || !(angle || (lens && sensor))) return std::nullopt;
  const double f = angle ? 0.5 * *width / std::tan(0.5 * *angle) : *lens / *sensor * *width;
  const Camera camera{CameraModel::kPinhole,
                      static_cast<int>(*width),
                      static_cast<int>(*height),
                      f,
                      f,
                      0.5 * *width - 0.5,
                      0.5 * *height - 0.5,
                      {},
                      {}};
  try {
    camera.check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
  return camera;
}

BlenderPath read_json(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const Json json = Json::parse(file, nullptr, false);
  if (json.is_discarded()) throw InputError(path, 0, "", "no JSON", "a camera path of Blender");
  if (!json.is_object() || !json.contains("frames") || !json["frames"].is_array() || json["frames"].empty())
    throw InputError(path, 0, "frames", "nothing", "a list of frames");
  BlenderPath answer;
  answer.fps = number_of(path, json, {"fps"});
  if (answer.fps && !(*answer.fps > 0))
    throw InputError(path, 0, "fps", shortest_text(*answer.fps), "more than 0");
  answer.camera = camera_of(path, json);
  std::size_t index = 0;
  for (const Json& frame : json["frames"]) {
    const JsonFrame entry{path, frame, index++};
    if (!frame.is_object())
      throw InputError(path, 0, fmt::format("frames[{}]", entry.index), frame.dump().substr(0, 60),
                       "an object");
    add_pose(path, 0, entry.number(), entry.pose(), answer);
  }
  return answer;
}

}  // namespace

BlenderPath read_blender_path(const fs::path& path) {
  if (!fs::is_regular_file(path)) throw InputError(path, 0, "", "no file", "a camera path of Blender");
  return extension_of(path) == ".json" ? read_json(path) : read_table(path);
}

}  // namespace framewise
