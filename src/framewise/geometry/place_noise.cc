// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/place_noise.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace framewise {

PlaceNoise PlaceNoise::of(const Eigen::Matrix2d& covariance) {
  const double square = covariance.trace() / 2;
  if (!(square > 0)) return {0, Eigen::Matrix2d::Identity()};  // of two images that are the same
  return {std::sqrt(square), covariance / square};
}

PlaceNoise PlaceNoise::at_least(double least) const {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(covariance());
  const Eigen::Vector2d squares = eigen.eigenvalues().cwiseMax(least * least);
  return of(eigen.eigenvectors() * squares.asDiagonal() * eigen.eigenvectors().transpose());
}

double PlaceNoise::least() const {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(shape, Eigen::EigenvaluesOnly);
  return sigma * std::sqrt(std::max(0.0, eigen.eigenvalues()[0]));
}

Eigen::Matrix2d PlaceNoise::whitening() const {
  const double a = std::sqrt(shape(0, 0)), b = shape(1, 0) / a;
  const double c = std::sqrt(std::max(1e-12, shape(1, 1) - b * b));
  Eigen::Matrix2d W;
  W << 1 / a, 0, -b / (a * c), 1 / c;
  return W / sigma;
}

}  // namespace framewise
