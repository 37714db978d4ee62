// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

// The checks that every door of this room makes of what it is given.
namespace framewise {

// Throws std::invalid_argument unless all numbers are finite. `door` and `argument` name the culprit.
void check_points(const char* door, const char* argument, std::span<const Eigen::Vector3d> points);

// The same, and that no bearing has length zero. Lengths other than 1 are welcome.
void check_bearings(const char* door, const char* argument, std::span<const Eigen::Vector3d> bearings);

// The same as check_bearings, and that all point forward, z > 0: rays of a pinhole camera.
void check_forward(const char* door, const char* argument, std::span<const Eigen::Vector3d> rays);

// NaN, 0 and less mean "no depth"; infinity is refused.
void check_depths(const char* door, const char* argument, std::span<const double> depths);

void check_same_size(const char* door, const char* first, std::size_t first_size, const char* second,
                     std::size_t second_size);

void check_rotation(const char* door, const char* argument, const Eigen::Matrix3d& R);

void check_positive(const char* door, const char* argument, double value);

}  // namespace framewise
