// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/io/yaml_fields.h"

namespace framewise {

// Cameras as YAML files of several programs describe them. Inside the room alone.

// Framewise's own fields: model, width, height; fx, fy, cx, cy, distortion; or theta_range_deg.
Camera read_own_camera(const YamlFields& fields);

// ROS camera_info (camera_matrix, distortion_coefficients, image_width; or the message's K, D, width) and
// OpenCV's FileStorage (the same names; !!opencv-matrix).
bool is_matrix_camera(const YamlFields& fields);
Camera read_matrix_camera(const YamlFields& fields);

// Kalibr's camera chain (cam0: camera_model, intrinsics, distortion_model, distortion_coeffs, resolution) and
// EuRoC's sensor.yaml (the same without cam0).
bool is_kalibr_camera(const YamlFields& fields);
Camera read_kalibr_camera(const YamlFields& fields);

// 12 or 16 numbers, row by row, of a rigid motion: a list, or a map with the list `data` (EuRoC's T_BS).
Pose read_pose(const YamlFields& fields, const std::string& name);

}  // namespace framewise
