// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/depth_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 64, 48, 50, 52, 31.5, 23.5};
const DepthNoise kNoNoise{1e-9, 0, 0.4};

Eigen::Vector2d ray_of(const Eigen::Vector2d& pixel) {
  return {(pixel.x() - kCamera.cx) / kCamera.fx, (pixel.y() - kCamera.cy) / kCamera.fy};
}

// 1/z = w + slope . ray, with normal noise on z.
struct Wall {
  double w;
  Eigen::Vector2d slope;
  double z_at(const Eigen::Vector2d& pixel) const { return 1 / (w + slope.dot(ray_of(pixel))); }
};

cv::Mat image_of(const Wall& wall, double sigma = 0, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  cv::Mat depth(kCamera.height, kCamera.width, CV_32F);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      double noise = -6;  // of twelve even numbers
      for (int i = 0; i < 12; ++i) noise += static_cast<double>(random()) / 4294967295.0;
      const double u_px = u, v_px = v;
      depth.at<float>(v, u) = static_cast<float>(wall.z_at({u_px, v_px}) + sigma * noise);
    }
  return depth;
}

TEST(DepthPlaneAt, ASlantedWallIsMetBetweenPixels) {
  const Wall wall{0.5, {0.2, -0.15}};
  const Eigen::Vector2d pixel(30.4, 20.3);
  const auto plane = depth_plane_at(image_of(wall), pixel, kCamera, kNoNoise, {});
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->z, wall.z_at(pixel), 1e-5);
  EXPECT_LT((plane->slope - wall.slope).norm(), 1e-4);
}

TEST(DepthPlaneAt, AtABorderTheWallGoesOn) {
  const Wall wall{0.5, {0.2, -0.15}};
  const Eigen::Vector2d pixel(2.4, 45.2);
  const auto plane = depth_plane_at(image_of(wall), pixel, kCamera, kNoNoise, {});
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->z, wall.z_at(pixel), 1e-5);
  EXPECT_FALSE(depth_plane_at(image_of(wall), {0.3, 20}, kCamera, kNoNoise, {}));
  EXPECT_FALSE(depth_plane_at(image_of(wall), {-50, 900}, kCamera, kNoNoise, {}));
}

TEST(DepthPlaneAt, WhatLiesBehindHasNoSay) {
  const Wall near{0.5, {0, 0}};
  cv::Mat depth = image_of(near);
  depth.colRange(32, 64).setTo(2.4f);
  depth.at<float>(19, 28) = std::numeric_limits<float>::quiet_NaN();
  const auto plane = depth_plane_at(depth, {30, 20}, kCamera, DepthNoise(), {});
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->z, 2, 1e-5);
  EXPECT_LT(plane->slope.norm(), 1e-4);
}

TEST(DepthPlaneAt, ItsNoiseIsTheShareItSaysWherePixelsHaveTheirOwn) {
  constexpr double kSigma = 0.01;
  const Wall wall{0.5, {0, 0}};
  DepthPlaneOptions options;
  options.noise_area_px = 1;
  double squares = 0, share2 = 0;
  constexpr int kRuns = 300;
  for (int run = 0; run < kRuns; ++run) {
    const auto plane = depth_plane_at(image_of(wall, kSigma, 10 + run), {30.4, 20.3}, kCamera,
                                      {kSigma, 0, 0.4}, {}, options);
    ASSERT_TRUE(plane);
    squares += std::pow((plane->z - 2) / kSigma, 2) / kRuns;
    share2 += plane->noise_share * plane->noise_share / kRuns;
  }
  EXPECT_LT(share2, 0.04);
  EXPECT_NEAR(squares / share2, 1, 0.25);
}

TEST(DepthPlaneAt, ASlopeThatNoiseHidesIsTakenForNone) {
  const Wall wall{0.5, {0.3, 0}};
  const DepthNoise sure{1e-5, 0, 0.4}, unsure{1, 0, 0.4};
  const cv::Mat depth = image_of(wall);
  EXPECT_NEAR(depth_plane_at(depth, {30, 20}, kCamera, sure, {})->slope.x(), 0.3, 1e-3);
  const auto plane = depth_plane_at(depth, {30, 20}, kCamera, unsure, {});
  EXPECT_LT(plane->slope.x(), 0.05);
  EXPECT_LE(plane->noise_share, 1);
}

}  // namespace
}  // namespace framewise
