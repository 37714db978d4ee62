// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/camera_file.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <array>
#include <numbers>
#include <stdexcept>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

// Reads typed fields of a YAML map and says which one is wrong.
class Fields {
 public:
  explicit Fields(const std::filesystem::path& path) : path_(path) {
    if (!std::filesystem::is_regular_file(path))
      throw InputError(path, 0, "", "no file", "a camera file (YAML)");
    try {
      root_ = YAML::LoadFile(path.string());
    } catch (const YAML::Exception& error) {
      throw InputError(path, error.mark.line + 1, "", error.msg, "YAML");
    }
    if (!root_.IsMap())
      throw InputError(path, 0, "", "no map of fields", "a camera file (model, width, height, fx, …)");
  }

  bool has(const std::string& name) const { return static_cast<bool>(root_[name]); }

  template <typename T>
  T get(const std::string& name, const char* expected) const {
    if (!root_[name]) throw InputError(path_, 0, name, "nothing", expected);
    try {
      return root_[name].as<T>();
    } catch (const YAML::Exception&) {
      throw InputError(path_, 0, name, "'" + YAML::Dump(root_[name]) + "'", expected);
    }
  }

  template <typename T>
  T get_or(const std::string& name, const T& otherwise, const char* expected) const {
    return root_[name] ? get<T>(name, expected) : otherwise;
  }

 private:
  std::filesystem::path path_;
  YAML::Node root_;
};

CameraModel read_model(const std::filesystem::path& path, const std::string& name) {
  if (const auto model = camera_model_from_name(name)) return *model;
  throw InputError(path, 0, "model", "'" + name + "'", "pinhole, fisheye or equirectangular");
}

DepthType read_depth_type(const std::filesystem::path& path, const Fields& fields, const Camera& camera,
                          DepthType otherwise) {
  const bool sphere = camera.model == CameraModel::kEquirectangular;
  const char* expected = sphere ? "range for an equirectangular camera" : "z or range";
  const auto name =
      fields.get_or<std::string>("depth_type", name_of(sphere ? DepthType::kRange : otherwise), expected);
  const auto type = depth_type_from_name(name);
  if (!type || (sphere && *type == DepthType::kZ))
    throw InputError(path, 0, "depth_type", "'" + name + "'", expected);
  return *type;
}

CameraFile pinhole_640x480(double fx, double fy, double cx, double cy,
                           const std::array<double, 5>& distortion) {
  CameraFile file;
  file.camera = {CameraModel::kPinhole, 640, 480, fx, fy, cx, cy, distortion};
  return file;
}

}  // namespace

CameraFile read_camera_file(const std::filesystem::path& path, const CameraFile& otherwise) {
  const Fields fields(path);
  CameraFile file;
  Camera& camera = file.camera;
  camera.model = read_model(path, fields.get_or<std::string>("model", "pinhole", "a model's name"));
  camera.width = fields.get<int>("width", "the images' width in pixels");
  camera.height = fields.get<int>("height", "the images' height in pixels");
  if (camera.model == CameraModel::kEquirectangular) {
    const auto degrees = fields.get<std::array<double, 2>>("theta_range_deg", "[from, to] in degrees");
    camera.theta_range = {degrees[0] * std::numbers::pi / 180, degrees[1] * std::numbers::pi / 180};
  } else {
    camera.fx = fields.get<double>("fx", "a focal length in pixels");
    camera.fy = fields.get<double>("fy", "a focal length in pixels");
    camera.cx = fields.get<double>("cx", "the principal point in pixels");
    camera.cy = fields.get<double>("cy", "the principal point in pixels");
    const auto values = fields.get_or<std::vector<double>>("distortion", {}, "a list of 4 or 5 numbers");
    const std::size_t most = camera.model == CameraModel::kPinhole ? 5 : 4;
    if (values.size() > most || (!values.empty() && values.size() < 4))
      throw InputError(path, 0, "distortion", fmt::format("{} numbers", values.size()),
                       most == 5 ? "k1, k2, p1, p2 and perhaps k3" : "k1, k2, k3, k4");
    std::copy(values.begin(), values.end(), camera.distortion.begin());
  }
  file.depth_type = read_depth_type(path, fields, camera, otherwise.depth_type);
  file.depth_max = fields.get_or<double>("depth_max", otherwise.depth_max, "metres");
  const bool full_scale = file.depth_type == DepthType::kRange && fields.has("depth_max");
  file.depth_factor = fields.get_or<double>(
      "depth_factor", full_scale ? 65535 / file.depth_max : otherwise.depth_factor, "raw units per metre");
  if (!(file.depth_factor > 0))
    throw InputError(path, 0, "depth_factor", fmt::format("{}", file.depth_factor), "more than 0");
  if (!(file.depth_max > 0))
    throw InputError(path, 0, "depth_max", fmt::format("{}", file.depth_max), "more than 0");
  try {
    camera.check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
  return file;
}

std::optional<DepthType> depth_type_from_name(const std::string& name) {
  for (const DepthType type : {DepthType::kZ, DepthType::kRange})
    if (name == name_of(type)) return type;
  return std::nullopt;
}

std::optional<CameraFile> tum_calibration(const std::string& name) {
  // Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012; values of its web page.
  if (name == "freiburg1")
    return pinhole_640x480(517.3, 516.5, 318.6, 255.3, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633});
  if (name == "freiburg2")
    return pinhole_640x480(520.9, 521.0, 325.1, 249.7, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172});
  if (name == "freiburg3") return pinhole_640x480(535.4, 539.2, 320.1, 247.6, {});
  return std::nullopt;
}

}  // namespace framewise
