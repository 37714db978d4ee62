// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/place_noise.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

const Eigen::Matrix2d kStriped = (Eigen::Matrix2d() << 2.3, -1.1, -1.1, 0.7).finished();

TEST(PlaceNoise, IsItsCovarianceWhoseShapeHasTraceTwo) {
  const PlaceNoise noise = PlaceNoise::of(kStriped);
  EXPECT_TRUE(noise.covariance().isApprox(kStriped, 1e-12));
  EXPECT_NEAR(noise.shape.trace(), 2, 1e-12);
}

TEST(PlaceNoise, OfTheSameImageTwiceIsTheLeastThereIs) {
  for (const double rounding : {0.0, -1e-18}) {
    const PlaceNoise noise = PlaceNoise::of(rounding * Eigen::Matrix2d::Identity());
    EXPECT_EQ(noise.sigma, 0);
    EXPECT_TRUE(noise.at_least(0.1).covariance().isApprox(0.01 * Eigen::Matrix2d::Identity(), 1e-12));
  }
}

TEST(PlaceNoise, WhiteningMakesItOne) {
  const Eigen::Matrix2d W = PlaceNoise::of(kStriped).whitening();
  EXPECT_TRUE((W * kStriped * W.transpose()).isIdentity(1e-9));
}

TEST(PlaceNoise, NoDirectionIsSurerThanTheLeast) {
  constexpr double kLeast = 0.6;
  const PlaceNoise noise = PlaceNoise::of(kStriped), floored = noise.at_least(kLeast);
  EXPECT_LT(noise.least(), kLeast);
  EXPECT_NEAR(floored.least(), kLeast, 1e-9);
  EXPECT_TRUE(noise.at_least(0.01).covariance().isApprox(kStriped, 1e-9));
  EXPECT_TRUE((PlaceNoise{0.1}.at_least(kLeast).covariance().isApprox(
      kLeast * kLeast * Eigen::Matrix2d::Identity(), 1e-12)));
}

}  // namespace
}  // namespace framewise
