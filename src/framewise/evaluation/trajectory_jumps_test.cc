// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/trajectory_jumps.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// A car that waits, starts with 3 m/s^2 and goes on.
Trajectory drive(double begin = 0, double x = 0) {
  Trajectory trajectory;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i, moving = std::max(0.0, t - 3);
    trajectory.add(begin + t, {so3_exp({0, 0.02 * i, 0}), {x + 1.5 * moving * moving, 0, 0}});
  }
  return trajectory;
}

TEST(TrajectoryJumps, AStartIsNone) { EXPECT_TRUE(find_jumps(drive()).empty()); }

TEST(TrajectoryJumps, ASecondRunIsOne) {
  Trajectory both = drive();
  const Trajectory second = drive(6, -40);
  for (std::size_t i = 0; i < second.size(); ++i) both.add(second.times[i], second.world_from_cam[i]);
  EXPECT_EQ(find_jumps(both), (std::vector<std::size_t>{60}));
}

TEST(TrajectoryJumps, ATurnOnTheSpotIsOne) {
  Trajectory trajectory;
  for (int i = 0; i < 20; ++i)
    trajectory.add(i, {so3_exp({0, 0.01 * i + (i >= 10 ? 1.0 : 0), 0}), {0, 0, 0}});
  EXPECT_EQ(find_jumps(trajectory), (std::vector<std::size_t>{10}));
}

TEST(TrajectoryJumps, AGapInTimeAloneIsNone) {
  Trajectory trajectory;
  for (int i = 0; i < 20; ++i) {
    const double t = i < 10 ? i : i + 30;
    trajectory.add(t, {Eigen::Matrix3d::Identity(), {0.2 * t, 0, 0}});
  }
  EXPECT_TRUE(find_jumps(trajectory).empty());
}

TEST(TrajectoryJumps, FewPosesHaveNone) {
  EXPECT_TRUE(find_jumps({}).empty());
  Trajectory two;
  two.add(0, {});
  two.add(1, {Eigen::Matrix3d::Identity(), {100, 0, 0}});
  EXPECT_TRUE(find_jumps(two).empty());
}

}  // namespace
}  // namespace framewise
