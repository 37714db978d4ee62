// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/residual_noise.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace framewise {

Eigen::Matrix3d measured_by_position(const PlacedBy& point) {
  const Eigen::Vector3d& x = point.x_in_cam;
  const double iz = 1 / x.z();
  Eigen::Matrix3d M;
  M << iz, 0, -x.x() * iz * iz, 0, iz, -x.y() * iz * iz, 0, 0, point.z_sigma > 0 ? 1 : 0;
  return M;
}

Likeness likeness_of_neighbours(const std::vector<PlacedBy>& points) {
  constexpr int kCells = 16;
  constexpr double kCell = 0.125;  // of the plane z = 1: a view of 90 degrees is 16 across
  std::array<Eigen::Vector3d, kCells * kCells> sums;
  sums.fill(Eigen::Vector3d::Zero());
  Eigen::Array3d squares = Eigen::Array3d::Zero(), of_sums = Eigen::Array3d::Zero();
  for (const PlacedBy& point : points) {
    const auto cell = [&](double x) {
      return std::clamp(static_cast<int>(std::floor(x / kCell)) + kCells / 2, 0, kCells - 1);
    };
    const Eigen::Vector3d& x = point.x_in_cam;
    Eigen::Vector3d r;
    r << point.ray_noise.whitening() * point.ray_residual,
        point.z_sigma > 0 ? point.z_residual / std::hypot(point.z_sigma, std::sqrt(point.S(2, 2))) : 0;
    sums[cell(x.x() / x.z()) * kCells + cell(x.y() / x.z())] += r;
    squares += r.array().square();
  }
  for (const Eigen::Vector3d& sum : sums) of_sums += sum.array().square();
  const double rays = squares.x() + squares.y();
  return {rays > 0 ? std::max(1.0, (of_sums.x() + of_sums.y()) / rays) : 1,
          squares.z() > 0 ? std::max(1.0, of_sums.z() / squares.z()) : 1};
}

ResidualTails residual_tails(const std::vector<PlacedBy>& points) {
  double ray = 0, z = 0, zs = 0;
  for (const PlacedBy& point : points) {
    const Eigen::Matrix3d M = measured_by_position(point);
    const Eigen::Matrix3d S = M * point.S * M.transpose();
    const Eigen::Matrix2d C = S.topLeftCorner<2, 2>() + point.ray_noise.covariance();
    ray += point.ray_residual.dot(C.inverse() * point.ray_residual) / 2;
    if (!(point.z_sigma > 0)) continue;
    z += point.z_residual * point.z_residual / (point.z_sigma * point.z_sigma + S(2, 2));
    ++zs;
  }
  return {points.empty() ? 1 : ray / static_cast<double>(points.size()), zs > 0 ? z / zs : 1};
}

}  // namespace framewise
