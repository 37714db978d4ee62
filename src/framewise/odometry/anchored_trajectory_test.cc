// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/anchored_trajectory.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

Pose at(double x) { return {so3_exp({0, 0.1 * x, 0}), {x, 0, 0}}; }

class Anchored : public testing::Test {
 protected:
  Anchored() : map(2) {
    for (int i = 0; i < 2; ++i) {
      map.add(std::make_shared<MapFrame>(), at(i));
      trajectory.add(i, at(i + 0.5), map);
    }
  }
  LocalMap map;
  AnchoredTrajectory trajectory;
};

TEST_F(Anchored, FramesAreWhereTheyWereAdded) {
  ASSERT_EQ(trajectory.poses(map).size(), 2u);
  for (int i = 0; i < 2; ++i)
    EXPECT_LT((trajectory.pose(i, map).matrix() - at(i + 0.5).matrix()).norm(), 1e-12);
}

TEST_F(Anchored, FramesMoveWithTheirKeyframeAlone) {
  const Pose moved{so3_exp({0.1, 0, 0.2}), {0, 3, 0}};
  map.at(1).world_from_cam = moved * map.at(1).world_from_cam;
  EXPECT_LT((trajectory.pose(0, map).matrix() - at(0.5).matrix()).norm(), 1e-12);
  EXPECT_LT((trajectory.pose(1, map).matrix() - (moved * at(1.5)).matrix()).norm(), 1e-12);
}

TEST_F(Anchored, FramesOfAKeyframeThatIsGoneAreWhereItEnded) {
  map.at(0).world_from_cam.t.y() = 5;
  map.add(std::make_shared<MapFrame>(), at(2));
  ASSERT_FALSE(map.holds(0));
  EXPECT_NEAR(trajectory.pose(0, map).t.y(), 5, 1e-12);
}

TEST_F(Anchored, AFrameThatIsToldOtherwiseLeavesTheOthers) {
  trajectory.replace(0, 1, at(7), map);
  EXPECT_LT((trajectory.pose(0, map).matrix() - at(7).matrix()).norm(), 1e-12);
  EXPECT_LT((trajectory.pose(1, map).matrix() - at(1.5).matrix()).norm(), 1e-12);
}

}  // namespace
}  // namespace framewise
