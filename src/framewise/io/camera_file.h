// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framewise/geometry/camera.h"

namespace framewise {

// A camera and how its depth files are to be read.
struct CameraFile {
  Camera camera;
  double depth_factor = 5000;  // raw value / factor = metres
  double depth_max = 10;       // farther is unknown (m)
};

// Reads Framewise's camera YAML: model, width, height, fx, fy, cx, cy, distortion, depth_factor, depth_max.
// Throws InputError that names the file and the field.
CameraFile read_camera_file(const std::filesystem::path& path);

// The published colour calibrations of the TUM RGB-D benchmark: "freiburg1", "freiburg2", "freiburg3".
std::optional<CameraFile> tum_calibration(const std::string& name);

}  // namespace framewise
