// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_rgbd_pair.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/solvers/levenberg_marquardt.h"
#include "framewise/solvers/refine_input.h"

namespace framewise {
namespace {

void set_point(PointColumns& columns, std::size_t row, std::size_t first, const Eigen::Vector3d& x, double z,
               const DepthNoise& noise, double image_sigma) {
  const Eigen::Vector3d X = point_at_depth(x, z);
  const Eigen::Matrix3d S = point_covariance(x, z, image_sigma, noise.sigma(z));
  columns.set3(row, first, X.x(), X.y(), X.z());
  columns.set3(row, first + 3, S(0, 0), S(0, 1), S(0, 2));
  columns.set3(row, first + 6, S(1, 1), S(1, 2), S(2, 2));
}

bool has_depth(double z) { return z > 0 && std::isfinite(z); }

}  // namespace

void fill_rgbd_pair(RgbdColumns& columns, std::span<const Eigen::Vector3d> x1, std::span<const double> z1,
                    std::span<const Eigen::Vector3d> x2, std::span<const double> z2, const DepthNoise& noise,
                    double image_sigma, std::span<const std::uint32_t> subset) {
  check_sizes("z1", z1.size(), "x1", x1.size());
  check_sizes("x2", x2.size(), "x1", x1.size());
  check_sizes("z2", z2.size(), "x1", x1.size());
  noise.check();
  const std::size_t rows = subset.empty() ? x1.size() : subset.size();
  const auto index = [&](std::size_t row) { return subset.empty() ? row : subset[row]; };
  const auto kind = [&](std::size_t i) { return (has_depth(z1[i]) ? 2 : 0) + (has_depth(z2[i]) ? 1 : 0); };
  std::array<std::size_t, 4> count = {};
  for (std::size_t row = 0; row < rows; ++row) {
    if (index(row) >= x1.size())
      throw std::invalid_argument("subset holds " + std::to_string(index(row)) + ", expected less than " +
                                  std::to_string(x1.size()));
    ++count[kind(index(row))];
  }
  columns.none.reset(count[0], 7);
  columns.second.reset(count[1], 13);
  columns.first.reset(count[2], 13);
  columns.both.reset(count[3], 19);
  std::array<std::size_t, 4> next = {};
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t i = index(row);
    const Eigen::Vector3d a = on_surface("x1", x1[i], ImageSurface::kPlane);
    const Eigen::Vector3d b = on_surface("x2", x2[i], ImageSurface::kPlane);
    const int has = kind(i);
    const std::size_t at = next[has]++;
    PointColumns* const sorted[4] = {&columns.none, &columns.second, &columns.first, &columns.both};
    if (has == 0) {
      columns.none.set3(at, 1, a.x(), a.y(), a.z());
      columns.none.set3(at, 4, b.x(), b.y(), b.z());
      continue;
    }
    PointColumns& c = *sorted[has];
    if (has & 2)
      set_point(c, at, 1, a, z1[i], noise, image_sigma);
    else
      set_point(c, at, 1, b, z2[i], noise, image_sigma);
    if (has == 3)
      set_point(c, at, 10, b, z2[i], noise, image_sigma);
    else
      c.set3(at, 10, (has == 2 ? b : a).x(), (has == 2 ? b : a).y(), 1);
  }
}

Refinement refine_rgbd_pair(const Pose& initial, const RgbdColumns& columns, const RefineOptions& options) {
  options.check();
  check_pose(initial);
  check_at_least("x1",
                 columns.both.rows() + columns.first.rows() + columns.second.rows() + columns.none.rows(), 3);
  const auto sums_at = [&](const Pose& pose) {
    const KernelPose k = kernel_pose(pose);
    NormalSums sums = sum_registration(columns.both, k, options.loss);
    if (columns.first.rows() > 0) sums += sum_point1_on_ray2(columns.first, k, options.sigma, options.loss);
    if (columns.second.rows() > 0) sums += sum_point2_on_ray1(columns.second, k, options.sigma, options.loss);
    if (columns.none.rows() > 0) sums += sum_sampson_plane(columns.none, k, options.sigma, options.loss);
    return sums;
  };
  return minimise<RigidMotion>(initial, sums_at, options);
}

Refinement refine_rgbd_pair(const Pose& initial, std::span<const Eigen::Vector3d> x1,
                            std::span<const double> z1, std::span<const Eigen::Vector3d> x2,
                            std::span<const double> z2, const DepthNoise& noise,
                            const RefineOptions& options) {
  options.check();
  RgbdColumns columns;
  fill_rgbd_pair(columns, x1, z1, x2, z2, noise, options.sigma);
  return refine_rgbd_pair(initial, columns, options);
}

}  // namespace framewise
