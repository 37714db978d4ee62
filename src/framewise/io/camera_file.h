// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framewise/geometry/camera.h"
#include "framewise/image/depth_rays.h"
#include "framewise/image/registration.h"

namespace framewise {

// A camera and how its depth files are to be read.
struct CameraFile {
  Camera camera;
  double depth_factor = 5000;            // raw value / factor = metres
  double depth_max = 10;                 // farther is unknown (m)
  DepthType depth_type = DepthType::kZ;  // equirectangular cameras: range
  // Depth images are of this camera and have to be moved into the other's; without it they are registered.
  std::optional<DepthCamera> depth_camera;

  // The camera whose pixels the depth files have.
  const Camera& camera_of_depth() const { return depth_camera ? depth_camera->camera : camera; }
};

// Reads a camera from YAML, told by its fields:
//   Framewise's own: model (pinhole, fisheye, equirectangular), width, height; fx, fy, cx, cy, distortion, or
//     theta_range_deg; and beside them depth_camera, a map of the same fields with camera_from_depth_camera,
//     12 or 16 numbers row by row;
//   ROS camera_info: image_width, image_height, camera_matrix, distortion_model, distortion_coefficients, or
//     the message itself: width, height, K, D;
//   Kalibr: cam0 with camera_model, intrinsics, distortion_model, distortion_coeffs, resolution; EuRoC's
//     sensor.yaml;
//   OpenCV's FileStorage: as ROS camera_info, with !!opencv-matrix.
// In each, depth_type (z or range), depth_factor and depth_max say how depth is read. What a file may leave
// out and does is taken from `otherwise`; but 16-bit ranges of which only depth_max is known reach from 0 to
// depth_max, so that their factor is 65535 / depth_max. Throws InputError that names the file and the field.
CameraFile read_camera_file(const std::filesystem::path& path, const CameraFile& otherwise = {});

// What was typed in place of what a camera file says; an empty type is none. As in the file, ranges of which
// only depth_max was typed reach from 0 to it.
void override_depth(CameraFile& file, const std::string& depth_type,
                    const std::optional<double>& depth_factor, const std::optional<double>& depth_max);

// "z" or "range"; empty for other names.
std::optional<DepthType> depth_type_from_name(const std::string& name);

// Published calibrations that need no file. "freiburg1", "freiburg2", "freiburg3": the colour cameras of the
// TUM RGB-D benchmark. "putkk-kinect1", "putkk-kinect2": PUTKK's. "icl-nuim": its renderer, turned upright.
// "7-scenes": a colour camera fitted to recordings of 7-Scenes, with the depth camera beside it;
// "7-scenes-depth": that depth camera alone.
std::optional<CameraFile> known_calibration(const std::string& name);

}  // namespace framewise
