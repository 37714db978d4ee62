// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "framewise/geometry/so3.h"
#include "framewise/simulation/path.h"
#include "framewise/simulation/room_scene.h"

namespace framewise {
namespace {

constexpr double kStep = 1.0 / 30;
constexpr int kFrames = 3000;

class HandheldPath : public testing::TestWithParam<std::uint64_t> {
 protected:
  const Path path_ = handheld_path(room_space(), GetParam());
};

TEST_P(HandheldPath, MovesAtTheSpeedOfAHand) {
  double sum = 0, fastest = 0, fastest_turn = 0;
  for (int i = 0; i < kFrames; ++i) {
    const Pose a = path_(i * kStep).world_from_cam, b = path_((i + 1) * kStep).world_from_cam;
    const double speed = (b.t - a.t).norm() / kStep;
    sum += speed;
    fastest = std::max(fastest, speed);
    fastest_turn = std::max(fastest_turn, rotation_angle(a.R.transpose() * b.R) / kStep);
  }
  EXPECT_GT(sum / kFrames, 0.2);
  EXPECT_LT(sum / kFrames, 0.5);
  EXPECT_LT(fastest, 0.65);
  EXPECT_LT(fastest_turn, 30 * M_PI / 180);
}

TEST_P(HandheldPath, StaysInItsSpaceForHours) {
  for (int i = 0; i < 100 * kFrames; i += 7)
    ASSERT_TRUE(room_space().free_space.contains(path_(i * kStep).world_from_cam.t)) << i;
}

TEST_P(HandheldPath, HoldsTheCameraUprightAndLooksDownALittle) {
  for (int i = 0; i < kFrames; ++i) {
    const Eigen::Matrix3d R = path_(i * kStep).world_from_cam.R;
    ASSERT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    ASSERT_NEAR(R.determinant(), 1, 1e-12);
    ASSERT_LT(R(2, 1), -0.9) << "down in the image is down in the world";
    ASSERT_LT(std::abs(R(2, 2)), 0.5) << "neither to the ceiling nor to the feet";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, HandheldPath, testing::Values(0, 1, 2, 3, 4));

TEST(RoomScene, NothingComesNearTheFreeSpace) {
  const Eigen::AlignedBox3d space = room_space().free_space;
  for (const std::uint64_t seed : {0, 1, 2, 3, 4}) {
    const Scene scene = room_scene({.seed = seed, .light_cell = 10, .lit = false});
    double nearest = 100;
    for (const auto& triangle : scene.triangles) {
      Eigen::AlignedBox3d extent;
      for (const std::uint32_t corner : triangle)
        extent.extend(scene.vertices[corner].position.cast<double>());
      nearest = std::min(nearest, space.exteriorDistance(extent));
    }
    EXPECT_GT(nearest, 0.4) << "seed " << seed;
  }
}

}  // namespace
}  // namespace framewise
