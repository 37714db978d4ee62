// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/correspondences_check.h"

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

void check_same_size(const char* door, const char* first, std::size_t first_size, const char* second,
                     std::size_t second_size) {
  if (first_size == second_size) return;
  refuse(door, ": ", second, " has ", second_size, " elements, expected ", first_size, " as ", first, " has");
}

void check_positive(const char* door, const char* argument, double value) {
  if (value > 0 && std::isfinite(value)) return;
  refuse(door, ": ", argument, " is ", value, ", expected a positive number");
}

}  // namespace framewise
