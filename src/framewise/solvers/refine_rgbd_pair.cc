// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_rgbd_pair.h"

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
  const auto both = [&](std::size_t i) { return has_depth(z1[i]) && has_depth(z2[i]); };
  std::size_t num_both = 0, num_first = 0, num_second = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t i = index(row);
    if (i >= x1.size())
      throw std::invalid_argument("subset holds " + std::to_string(i) + ", expected less than " +
                                  std::to_string(x1.size()));
    num_both += both(i);
    num_first += !both(i) && has_depth(z1[i]);
    num_second += !both(i) && has_depth(z2[i]);
  }
  columns.both.reset(num_both, 19);
  columns.first.reset(num_first, 13);
  columns.second.reset(num_second, 13);
  columns.none.reset(rows - num_both - num_first - num_second, 7);

  std::size_t next_both = 0, next_first = 0, next_second = 0, next_none = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t i = index(row);
    const Eigen::Vector3d a = on_surface("x1", x1[i], ImageSurface::kPlane);
    const Eigen::Vector3d b = on_surface("x2", x2[i], ImageSurface::kPlane);
    if (both(i)) {
      set_point(columns.both, next_both, 1, a, z1[i], noise, image_sigma);
      set_point(columns.both, next_both++, 10, b, z2[i], noise, image_sigma);
    } else if (has_depth(z1[i])) {
      set_point(columns.first, next_first, 1, a, z1[i], noise, image_sigma);
      columns.first.set3(next_first++, 10, b.x(), b.y(), b.z());
    } else if (has_depth(z2[i])) {
      set_point(columns.second, next_second, 1, b, z2[i], noise, image_sigma);
      columns.second.set3(next_second++, 10, a.x(), a.y(), a.z());
    } else {
      columns.none.set3(next_none, 1, a.x(), a.y(), a.z());
      columns.none.set3(next_none++, 4, b.x(), b.y(), b.z());
    }
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
