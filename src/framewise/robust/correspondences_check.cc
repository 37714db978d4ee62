// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/correspondences_check.h"

#include <Eigen/LU>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace framewise {
namespace {

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

}  // namespace

void check_points(const char* door, const char* argument, std::span<const Eigen::Vector3d> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) continue;
    refuse(door, ": ", argument, "[", i, "] is (", points[i].transpose(), "), expected finite numbers");
  }
}

void check_bearings(const char* door, const char* argument, std::span<const Eigen::Vector3d> bearings) {
  check_points(door, argument, bearings);
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    if (bearings[i].norm() > 0) continue;
    refuse(door, ": ", argument, "[", i, "] has length zero, expected a direction");
  }
}

void check_forward(const char* door, const char* argument, std::span<const Eigen::Vector3d> rays) {
  check_points(door, argument, rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].z() > 0) continue;
    refuse(door, ": ", argument, "[", i, "] has z ", rays[i].z(), ", expected a ray that points forward");
  }
}

void check_depths(const char* door, const char* argument, std::span<const double> depths) {
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (!std::isinf(depths[i])) continue;
    refuse(door, ": ", argument, "[", i, "] is infinite, expected metres, or NaN where there is none");
  }
}

void check_same_size(const char* door, const char* first, std::size_t first_size, const char* second,
                     std::size_t second_size) {
  if (first_size == second_size) return;
  refuse(door, ": ", second, " has ", second_size, " elements, expected ", first_size, " as ", first, " has");
}

void check_rotation(const char* door, const char* argument, const Eigen::Matrix3d& R) {
  const double off = (R.transpose() * R - Eigen::Matrix3d::Identity()).norm();
  if (off < 1e-6 && R.determinant() > 0) return;
  refuse(door, ": ", argument, " is ", off, " off orthonormal with determinant ", R.determinant(),
         ", expected a rotation");
}

void check_positive(const char* door, const char* argument, double value) {
  if (value > 0 && std::isfinite(value)) return;
  refuse(door, ": ", argument, " is ", value, ", expected a positive number");
}

}  // namespace framewise
