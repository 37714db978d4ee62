// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_input.h"

#include <sstream>
#include <stdexcept>
#include <string>

namespace framewise {
namespace {

[[noreturn]] void refuse(const std::string& name, const Eigen::Vector3d& x, const char* expected) {
  std::ostringstream text;
  text << name << " holds (" << x.transpose() << "), expected " << expected;
  throw std::invalid_argument(text.str());
}

template <typename SetRow>
void fill(PointColumns& columns, std::size_t size, std::span<const std::uint32_t> subset,
          const SetRow& set_row) {
  columns.reset(subset.empty() ? size : subset.size(), 7);
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    const std::size_t i = subset.empty() ? row : subset[row];
    if (i >= size)
      throw std::invalid_argument("subset holds " + std::to_string(i) + ", expected less than " +
                                  std::to_string(size));
    set_row(row, i);
  }
}

}  // namespace

Eigen::Vector3d on_surface(const char* name, const Eigen::Vector3d& x, ImageSurface surface) {
  const bool plane = surface == ImageSurface::kPlane;
  const double length = plane ? x.z() : x.norm();
  if (!x.allFinite() || !(length > 0))
    refuse(name, x, plane ? "finite rays with z > 0" : "finite rays of a length above 0");
  return x / length;
}

void fill_ray_pairs(PointColumns& columns, Points x1, Points x2, ImageSurface surface,
                    std::span<const std::uint32_t> subset) {
  check_sizes("x2", x2.size(), "x1", x1.size());
  fill(columns, x1.size(), subset, [&](std::size_t row, std::size_t i) {
    const Eigen::Vector3d a = on_surface("x1", x1[i], surface), b = on_surface("x2", x2[i], surface);
    columns.set3(row, 1, a.x(), a.y(), a.z());
    columns.set3(row, 4, b.x(), b.y(), b.z());
  });
}

void fill_points_and_rays(PointColumns& columns, Points X1, Points x2, ImageSurface surface,
                          std::span<const std::uint32_t> subset) {
  check_sizes("x2", x2.size(), "X1", X1.size());
  fill(columns, X1.size(), subset, [&](std::size_t row, std::size_t i) {
    if (!X1[i].allFinite()) refuse("X1", X1[i], "finite points");
    const Eigen::Vector3d b = on_surface("x2", x2[i], surface);
    columns.set3(row, 1, X1[i].x(), X1[i].y(), X1[i].z());
    columns.set3(row, 4, b.x(), b.y(), b.z());
  });
}

void check_pose(const Pose& initial) {
  const double off = (initial.R.transpose() * initial.R - Eigen::Matrix3d::Identity()).norm();
  if (!(off < 1e-6))
    throw std::invalid_argument("initial.R is " + std::to_string(off) +
                                " off orthonormal, expected a rotation");
  if (!initial.t.allFinite()) refuse("initial.t", initial.t, "finite numbers");
}

void check_sizes(const char* name, std::size_t size, const char* name_of_first, std::size_t size_of_first) {
  if (size != size_of_first)
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(size) + " entries, expected " +
                                std::to_string(size_of_first) + " as " + name_of_first + " has");
}

void check_at_least(const char* name, std::size_t size, std::size_t needed) {
  if (size < needed)
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(size) + " entries, expected " +
                                std::to_string(needed) + " or more");
}

void check_finite(const char* name, Points X) {
  for (const auto& x : X)
    if (!x.allFinite()) refuse(name, x, "finite points");
}

}  // namespace framewise
