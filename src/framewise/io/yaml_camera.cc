// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/yaml_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "framewise/io/pose_rows.h"

namespace framewise {
namespace {

using Numbers = std::vector<double>;

// The first of several names that the file has; the first of all where it has none, for the message.
std::string name_used(const YamlFields& fields, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (fields.has(name)) return name;
  return *names.begin();
}

// A list of numbers, or a matrix with the list `data`.
Numbers read_numbers(const YamlFields& fields, const std::string& name, const char* expected) {
  if (!fields.has(name)) return fields.get<Numbers>(name, expected);
  const YAML::Node node = fields.get<YAML::Node>(name, expected);
  return node.IsMap() ? fields.map(name).get<Numbers>("data", expected) : fields.get<Numbers>(name, expected);
}

[[noreturn]] void refuse(const YamlFields& fields, const std::string& name, const std::string& found,
                         const std::string& expected) {
  throw InputError(fields.path(), 0, fields.full_name(name), found, expected);
}

// OpenCV's k1 k2 p1 p2 k3, or the fisheye's four; what follows (k4 to k6, thin prisms) must be 0.
std::array<double, 5> distortion_of(const YamlFields& fields, const std::string& name, const Numbers& values,
                                    CameraModel model) {
  const std::size_t most = model == CameraModel::kPinhole ? 5 : 4;
  const bool too_many =
      std::any_of(values.begin() + static_cast<std::ptrdiff_t>(std::min(most, values.size())), values.end(),
                  [](double k) { return k != 0; });
  if (too_many || (!values.empty() && values.size() < 4))
    refuse(fields, name, fmt::format("{} numbers", values.size()),
           most == 5 ? "k1, k2, p1, p2 and perhaps k3" : "k1, k2, k3, k4");
  std::array<double, 5> distortion{};
  std::copy_n(values.begin(), std::min(most, values.size()), distortion.begin());
  return distortion;
}

CameraModel read_model(const YamlFields& fields) {
  const auto name = fields.get_or<std::string>("model", "pinhole", "a model's name");
  if (const auto model = camera_model_from_name(name)) return *model;
  refuse(fields, "model", "'" + name + "'", "pinhole, fisheye or equirectangular");
}

// Names of OpenCV's pinhole model and of its fisheye model.
CameraModel model_of_distortion(const YamlFields& fields, const std::string& name) {
  const auto found = fields.get_or<std::string>(name, "plumb_bob", "a distortion model's name");
  for (const char* known : {"plumb_bob", "radtan", "radial-tangential", "rational_polynomial", "none", ""})
    if (found == known) return CameraModel::kPinhole;
  for (const char* known : {"equidistant", "fisheye"})
    if (found == known) return CameraModel::kFisheye;
  refuse(fields, name, "'" + found + "'", "radtan, plumb_bob or equidistant");
}

void read_size(const YamlFields& fields, const std::string& name, Camera& camera) {
  const auto size = fields.get<std::array<int, 2>>(name, "[width, height] in pixels");
  camera.width = size[0];
  camera.height = size[1];
}

}  // namespace

Camera read_own_camera(const YamlFields& fields) {
  Camera camera;
  camera.model = read_model(fields);
  camera.width = fields.get<int>("width", "the images' width in pixels");
  camera.height = fields.get<int>("height", "the images' height in pixels");
  if (camera.model == CameraModel::kEquirectangular) {
    const auto degrees = fields.get<std::array<double, 2>>("theta_range_deg", "[from, to] in degrees");
    camera.theta_range = {degrees[0] * std::numbers::pi / 180, degrees[1] * std::numbers::pi / 180};
    return camera;
  }
  camera.fx = fields.get<double>("fx", "a focal length in pixels");
  camera.fy = fields.get<double>("fy", "a focal length in pixels");
  camera.cx = fields.get<double>("cx", "the principal point in pixels");
  camera.cy = fields.get<double>("cy", "the principal point in pixels");
  const auto values = fields.get_or<Numbers>("distortion", {}, "a list of 4 or 5 numbers");
  camera.distortion = distortion_of(fields, "distortion", values, camera.model);
  return camera;
}

bool is_matrix_camera(const YamlFields& fields) {
  for (const char* name : {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K", "k"})
    if (fields.has(name)) return true;
  return false;
}

Camera read_matrix_camera(const YamlFields& fields) {
  Camera camera;
  const std::string width = name_used(fields, {"image_width", "image_Width", "width"});
  const std::string height = name_used(fields, {"image_height", "image_Height", "height"});
  camera.width = fields.get<int>(width, "the images' width in pixels");
  camera.height = fields.get<int>(height, "the images' height in pixels");
  camera.model = fields.get_or<int>("fisheye_model", 0, "0 or 1") != 0
                     ? CameraModel::kFisheye
                     : model_of_distortion(fields, "distortion_model");

  const std::string name = name_used(fields, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K", "k"});
  const Numbers K = read_numbers(fields, name, "9 numbers");
  if (K.size() != 9 || K[1] != 0 || K[3] != 0 || K[6] != 0 || K[7] != 0 || K[8] != 1)
    refuse(fields, name, fmt::format("[{}]", fmt::join(K, ", ")), "[fx, 0, cx, 0, fy, cy, 0, 0, 1]");
  camera.fx = K[0], camera.cx = K[2], camera.fy = K[4], camera.cy = K[5];

  const std::string coefficients = name_used(
      fields, {"distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs", "D", "d"});
  if (fields.has(coefficients))
    camera.distortion = distortion_of(fields, coefficients,
                                      read_numbers(fields, coefficients, "a list of numbers"), camera.model);
  return camera;
}

bool is_kalibr_camera(const YamlFields& fields) { return fields.has("cam0") || fields.has("intrinsics"); }

Camera read_kalibr_camera(const YamlFields& whole) {
  const YamlFields fields = whole.has("cam0") ? whole.map("cam0") : whole;
  const auto kind = fields.get_or<std::string>("camera_model", "pinhole", "a model's name");
  if (kind != "pinhole") refuse(fields, "camera_model", "'" + kind + "'", "pinhole");
  Camera camera;
  camera.model = model_of_distortion(fields, "distortion_model");
  read_size(fields, "resolution", camera);
  const auto intrinsics = fields.get<std::array<double, 4>>("intrinsics", "[fu, fv, pu, pv]");
  camera.fx = intrinsics[0], camera.fy = intrinsics[1], camera.cx = intrinsics[2], camera.cy = intrinsics[3];
  const std::string name = name_used(fields, {"distortion_coeffs", "distortion_coefficients"});
  camera.distortion =
      distortion_of(fields, name, fields.get_or<Numbers>(name, {}, "a list of numbers"), camera.model);
  return camera;
}

Pose read_pose(const YamlFields& fields, const std::string& name) {
  const char* expected = "12 or 16 numbers, a rigid motion row by row";
  const Numbers values = read_numbers(fields, name, expected);
  if (values.size() != 12 && values.size() != 16)
    refuse(fields, name, fmt::format("{} numbers", values.size()), expected);
  if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
    refuse(fields, name, "a number that is not finite", expected);
  Pose pose;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      (j < 3 ? pose.R(i, j) : pose.t(i)) = values[static_cast<std::size_t>(4 * i + j)];
  expect_rotation(fields.path(), 0, pose.R);
  return pose;
}

}  // namespace framewise
