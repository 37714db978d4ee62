// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "recording.h"

namespace framewise::apps {

using RotationSource = std::function<std::optional<Eigen::Matrix3d>(std::size_t index1, std::size_t index2)>;

// What --rotation names: truth (the recording's), gyro (the data set's gyroscope), or a file: a trajectory of
// the camera (TUM, KITTI with stamps, EuRoC) or a gyroscope in the camera's axes (4 or 7 columns; EuRoC's
// imu0/data.csv). The answer, cam2_from_cam1, is empty where the source does not reach. The recording must
// outlive it. Throws InputError where the source is not there or covers none of the recording's frames.
RotationSource rotation_source(const std::string& choice, const Recording& recording, double max_gap);

}  // namespace framewise::apps
