// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "framewise/geometry/pose.h"
#include "framewise/io/number_rows.h"

namespace framewise {

// Poses in rows of numbers. All throw InputError that names the file, the line, and what makes it no pose.

// A rotation in rows, as printed: no nearer rotation is made of it, which would move what other tools measure
// in the last digits. R R' may be away from the identity by 1e-3.
void expect_rotation(const std::filesystem::path& path, std::size_t line, const Eigen::Matrix3d& R);

// 12 fields from `first` on: a 3x4 matrix row by row.
Pose pose_of_matrix(const NumberRows& rows, const NumberRow& row, std::size_t first = 0);

// A quaternion of any length but none.
Pose pose_of_quaternion(const NumberRows& rows, const NumberRow& row, const Eigen::Vector3d& t,
                        const Eigen::Quaterniond& q);

}  // namespace framewise
