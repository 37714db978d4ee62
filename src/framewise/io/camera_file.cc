// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/camera_file.h"

#include <fmt/format.h>

#include <stdexcept>

#include "framewise/io/input_error.h"
#include "framewise/io/yaml_camera.h"

namespace framewise {
namespace {

Camera read_any_camera(const YamlFields& fields) {
  // A file of our own may have fields of others beside ours.
  if (fields.has("fx") || fields.has("model")) return read_own_camera(fields);
  if (is_matrix_camera(fields)) return read_matrix_camera(fields);
  if (is_kalibr_camera(fields)) return read_kalibr_camera(fields);
  return read_own_camera(fields);
}

void check_camera(const std::filesystem::path& path, const char* name, const Camera& camera) {
  try {
    camera.check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}{}", path.string(), name, error.what()));
  }
}

std::optional<DepthCamera> read_depth_camera(const YamlFields& fields) {
  if (!fields.has("depth_camera")) return std::nullopt;
  const YamlFields depth = fields.map("depth_camera");
  const DepthCamera depth_camera{read_own_camera(depth), read_pose(depth, "camera_from_depth_camera")};
  check_camera(fields.path(), "depth_camera: ", depth_camera.camera);
  if (depth_camera.camera.model == CameraModel::kEquirectangular)
    throw InputError(fields.path(), 0, "depth_camera.model", "'equirectangular'", "pinhole or fisheye");
  return depth_camera;
}

DepthType read_depth_type(const YamlFields& fields, const Camera& camera, DepthType otherwise) {
  const bool sphere = camera.model == CameraModel::kEquirectangular;
  const char* expected = sphere ? "range for an equirectangular camera" : "z or range";
  const auto name =
      fields.get_or<std::string>("depth_type", name_of(sphere ? DepthType::kRange : otherwise), expected);
  const auto type = depth_type_from_name(name);
  if (!type || (sphere && *type == DepthType::kZ))
    throw InputError(fields.path(), 0, "depth_type", "'" + name + "'", expected);
  return *type;
}

double full_scale_factor(double depth_max) { return 65535 / depth_max; }

}  // namespace

CameraFile read_camera_file(const std::filesystem::path& path, const CameraFile& otherwise) {
  const YamlFields fields(path);
  CameraFile file;
  file.camera = read_any_camera(fields);
  file.depth_camera = read_depth_camera(fields);
  file.depth_type = read_depth_type(fields, file.camera, otherwise.depth_type);
  file.depth_max = fields.get_or<double>("depth_max", otherwise.depth_max, "metres");
  const bool full_scale = file.depth_type == DepthType::kRange && fields.has("depth_max");
  file.depth_factor = fields.get_or<double>(
      "depth_factor", full_scale ? full_scale_factor(file.depth_max) : otherwise.depth_factor,
      "raw units per metre");
  if (!(file.depth_factor > 0))
    throw InputError(path, 0, "depth_factor", fmt::format("{}", file.depth_factor), "more than 0");
  if (!(file.depth_max > 0))
    throw InputError(path, 0, "depth_max", fmt::format("{}", file.depth_max), "more than 0");
  check_camera(path, "", file.camera);
  return file;
}

void override_depth(CameraFile& file, const std::string& depth_type,
                    const std::optional<double>& depth_factor, const std::optional<double>& depth_max) {
  if (!depth_type.empty()) {
    const auto type = depth_type_from_name(depth_type);
    if (!type)
      throw std::invalid_argument(fmt::format("depth-type: found '{}', expected z or range", depth_type));
    file.depth_type = *type;
  }
  if (depth_max) {
    file.depth_max = *depth_max;
    if (file.depth_type == DepthType::kRange) file.depth_factor = full_scale_factor(file.depth_max);
  }
  file.depth_factor = depth_factor.value_or(file.depth_factor);
}

std::optional<DepthType> depth_type_from_name(const std::string& name) {
  for (const DepthType type : {DepthType::kZ, DepthType::kRange})
    if (name == name_of(type)) return type;
  return std::nullopt;
}

}  // namespace framewise
