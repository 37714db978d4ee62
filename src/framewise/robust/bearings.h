// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"

namespace framewise {

using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// The plane z = 1, unless a bearing is 80 degrees or more off the axis: no pinhole camera sees it.
inline ImageSurface surface_of(std::span<const Bearing> bearings) {
  constexpr double kLeastZ = 0.17;
  for (const Bearing& x : bearings) {
    if (x.z() < kLeastZ) return ImageSurface::kSphere;
  }
  return ImageSurface::kPlane;
}

inline ImageSurface common_surface(std::span<const Bearing> x1, std::span<const Bearing> x2) {
  return surface_of(x1) == ImageSurface::kPlane ? surface_of(x2) : ImageSurface::kSphere;
}

inline std::vector<Bearing> normalized(std::span<const Bearing> bearings) {
  std::vector<Bearing> unit(bearings.begin(), bearings.end());
  for (Bearing& x : unit) x.normalize();
  return unit;
}

// The members of a sample.
template <std::size_t N>
std::array<Eigen::Vector3d, N> gather(std::span<const Eigen::Vector3d> x,
                                      std::span<const std::uint32_t> sample) {
  std::array<Eigen::Vector3d, N> members;
  for (std::size_t i = 0; i < N; ++i) members[i] = x[sample[i]];
  return members;
}

}  // namespace framewise
