// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "framewise/io/camera_file.h"

namespace framewise {

// The path of a camera as exported from Blender.
struct BlenderPath {
  std::map<long, Pose> world_from_cam;  // by the frame's number; of a camera that looks along z, y down
  std::optional<double> fps;
  std::optional<Camera> camera;
};

// Reads, by the file's ending,
//   .csv, .txt: a line that names the columns, then a line a frame. Columns, in any order: frame; x, y, z
//   (m); and
//     qw, qx, qy, qz, or rx, ry, rz (rad), or rx_deg, ry_deg, rz_deg: Euler angles of the order XYZ. Others
//     are passed over.
//   .json: {"frames": [...], ...}, each with "frame" (else the last number in "file_path"), and "location"
//   [x, y,
//     z] with "rotation_quaternion" [w, x, y, z] or "rotation_euler" [x, y, z] (rad, XYZ); or "matrix_world"
//     or "transform_matrix", 4 rows of 4. Beside the frames perhaps "fps"; and the camera: "width" and
//     "height" (or "w", "h") with "lens" and "sensor_width" (mm, horizontal fit), or "camera_angle_x" (rad).
// All of Blender's world and camera, as its Python interface gives them. Throws InputError that names the
// file, the line or the frame, and the field.
BlenderPath read_blender_path(const std::filesystem::path& path);

}  // namespace framewise
