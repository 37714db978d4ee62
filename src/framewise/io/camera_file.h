// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framewise/geometry/camera.h"
#include "framewise/image/depth_rays.h"

namespace framewise {

// A camera and how its depth files are to be read.
struct CameraFile {
  Camera camera;
  double depth_factor = 5000;            // raw value / factor = metres
  double depth_max = 10;                 // farther is unknown (m)
  DepthType depth_type = DepthType::kZ;  // equirectangular cameras: range
};

// Reads Framewise's camera YAML: model (pinhole, fisheye, equirectangular), width, height; fx, fy, cx, cy,
// distortion, or theta_range_deg; depth_type (z or range), depth_factor, depth_max. What a file may leave out
// and does is taken from `otherwise`; but 16-bit ranges of which only depth_max is known reach from 0 to
// depth_max, so that their factor is 65535 / depth_max. Throws InputError that names the file and the field.
CameraFile read_camera_file(const std::filesystem::path& path, const CameraFile& otherwise = {});

// "z" or "range"; empty for other names.
std::optional<DepthType> depth_type_from_name(const std::string& name);

// The published colour calibrations of the TUM RGB-D benchmark: "freiburg1", "freiburg2", "freiburg3".
std::optional<CameraFile> tum_calibration(const std::string& name);

}  // namespace framewise
