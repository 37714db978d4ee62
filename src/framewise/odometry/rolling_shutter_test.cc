// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/rolling_shutter.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"
#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 640, 480, 525, 525, 319.5, 239.5};

TEST(Shutter, WithoutReadoutChangesNothing) {
  const Shutter shutter{0, {1, -2, 0.5}};
  const Eigen::Vector3d ray(0.2, -0.3, 1);
  EXPECT_EQ(shutter.at_middle(ray, 0.4), ray);
  EXPECT_EQ(*shutter.project(kCamera, ray), *kCamera.project(ray));
}

TEST(Shutter, ProjectsToThePixelWhoseRayItTurnsBack) {
  const Shutter shutter{0.02, {0.9, -1.5, 0.7}};
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(20, 15), Eigen::Vector2d(600, 30),
                                       Eigen::Vector2d(320, 240), Eigen::Vector2d(90, 460)}) {
    const Eigen::Vector3d bearing = *kCamera.bearing(pixel), ray = bearing / bearing.z();
    const Eigen::Vector3d middle = shutter.at_middle(ray, row_of(kCamera, pixel.y()));
    EXPECT_LT((*shutter.project(kCamera, 3 * middle) - pixel).norm(), 0.05);
    EXPECT_NEAR(shutter.depth_at_middle(ray, 0, 2.5), 2.5, 1e-12);
  }
}

TEST(Shutter, DerivativeByTheReadoutIsThatOfTheRay) {
  const Eigen::Vector3d turn_rate(0.4, 1.1, -0.6), ray(0.3, 0.2, 1);
  const double row = -0.35, step = 1e-6;
  const Eigen::Vector3d low = Shutter{-step, turn_rate}.at_middle(ray, row),
                        high = Shutter{step, turn_rate}.at_middle(ray, row);
  EXPECT_LT(((high - low) / (2 * step) - Shutter{0, turn_rate}.at_middle_by_readout(ray, row)).norm(), 1e-6);
}

TEST(ReadoutEstimate, ComesToWhatEveryFrameSaysAndStaysWithinAFrame) {
  ReadoutEstimate estimate;
  for (int i = 0; i < 40; ++i) estimate.add(0.018 - estimate.seconds(), 1e5, 0.033);
  EXPECT_NEAR(estimate.seconds(), 0.018, 1e-3);
  const double before = estimate.seconds();
  estimate.add(std::nan(""), 1e9, 0.033);
  estimate.add(0.01, 0, 0.033);
  EXPECT_EQ(estimate.seconds(), before);
  for (int i = 0; i < 400; ++i) estimate.add(1, 1e6, 0.033);
  EXPECT_LE(estimate.seconds(), 0.033);
}

TEST(ReadoutEstimate, OfAGlobalShutterIsZeroWhateverNoiseSays) {
  ReadoutEstimate estimate;
  testing::Random random(2);
  for (int i = 0; i < 300; ++i) {
    estimate.add(0.001 + 0.004 * random.normal() - estimate.seconds(), 1e5, 0.033);
    EXPECT_EQ(estimate.seconds(), 0);
  }
}

TEST(ReadoutEstimate, WaitsUntilItIsSureThatAShutterRolls) {
  ReadoutEstimate estimate;
  estimate.add(0.02, 2e3, 0.033);
  EXPECT_EQ(estimate.seconds(), 0);
  for (int i = 0; i < 60; ++i) estimate.add(0.02 - estimate.seconds(), 2e3, 0.033);
  EXPECT_NEAR(estimate.seconds(), 0.02, 2e-3);
}

}  // namespace
}  // namespace framewise
