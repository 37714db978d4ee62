// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/depth_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace framewise {
namespace {

TEST(DepthNoise, GrowsWithTheSquareOfTheDistance) {
  const DepthNoise noise;
  EXPECT_DOUBLE_EQ(noise.sigma(0.4), 0.0012);
  EXPECT_NEAR(noise.sigma(2.4), 0.0012 + 4 * 0.0019, 1e-15);
  EXPECT_THROW((DepthNoise{0, 1, 1}.check()), std::invalid_argument);
  EXPECT_THROW((DepthNoise{1, -1, 1}.check()), std::invalid_argument);
  EXPECT_THROW((DepthNoise{1, 1, NAN}.check()), std::invalid_argument);
  EXPECT_NO_THROW(noise.check());
}

TEST(DepthNoise, CovarianceIsTheJacobianTimesTheNoise) {
  const Eigen::Vector3d x(0.3, -0.2, 1);
  const double z = 3, image = 0.002, depth = 0.02, h = 1e-6;
  Eigen::Matrix3d J;  // d point / d (u, v, z)
  J.col(0) = (point_at_depth(x + Eigen::Vector3d(h, 0, 0), z) - point_at_depth(x, z)) / h;
  J.col(1) = (point_at_depth(x + Eigen::Vector3d(0, h, 0), z) - point_at_depth(x, z)) / h;
  J.col(2) = (point_at_depth(x, z + h) - point_at_depth(x, z)) / h;
  const Eigen::Matrix3d expected =
      J * Eigen::Vector3d(image * image, image * image, depth * depth).asDiagonal() * J.transpose();
  EXPECT_LT((point_covariance(x, z, image, depth) - expected).norm(), 1e-12);
  // A bearing's length says nothing.
  EXPECT_LT((point_covariance(5 * x, z, image, depth) - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace framewise
