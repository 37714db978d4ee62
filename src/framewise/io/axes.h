// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/geometry/pose.h"

namespace framewise {

// From other conventions of axes to a camera that looks along z, x right, y down.

// A pose of a world and a camera whose y points up (left-handed, ICL-NUIM's) with both seen in the mirror y
// -> -y: S pose S, S = diag(1, -1, 1).
Pose mirrored_in_y(const Pose& world_from_cam);

// Blender's and OpenGL's camera looks along -z, y up: world_from_cam = world_from_blender_cam diag(1, -1,
// -1).
Pose from_blender_camera(const Pose& world_from_blender_cam);

// Blender's Euler angles of the order XYZ (rad): first about x, then y, then z, of the fixed axes.
Eigen::Matrix3d rotation_of_euler_xyz(const Eigen::Vector3d& angles);

}  // namespace framewise
