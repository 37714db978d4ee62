// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/trajectory_joiner.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// The camera moves 1 m along its own z in every step and turns a little.
Step forward(double metres = 1) {
  Step step;
  step.status = Status::kOk;
  step.cam2_from_cam1 = Pose{so3_exp({0, 0.1 * metres, 0}), {0, 0, metres}}.inverse();
  return step;
}

Step lost() { return Step(); }

Step never_called(std::size_t) {
  ADD_FAILURE() << "the step from the frame before should have served";
  return Step();
}

TEST(TrajectoryJoiner, MultipliesStepsIntoPoses) {
  TrajectoryJoiner joiner(1.0);
  joiner.start(0);
  Pose expected;
  for (int i = 1; i < 50; ++i) {
    const auto joined = joiner.add(0.1 * i, forward(), never_called);
    expected = expected * forward().cam2_from_cam1.inverse();
    EXPECT_LT((joined.world_from_cam.matrix() - expected.matrix()).norm(), 1e-11);
  }
}

TEST(TrajectoryJoiner, RepeatsTheLastPoseWhileLost) {
  TrajectoryJoiner joiner(1.0);
  joiner.start(0);
  const Pose last = joiner.add(0.1, forward(), never_called).world_from_cam;
  const auto joined = joiner.add(0.2, lost(), never_called);
  EXPECT_EQ(joined.step.status, Status::kLost);
  EXPECT_EQ(joined.world_from_cam.matrix(), last.matrix());
}

TEST(TrajectoryJoiner, BridgesALossByTheLastGoodFrame) {
  TrajectoryJoiner joiner(1.0);
  joiner.start(0);
  joiner.add(0.1, forward(), never_called);
  joiner.add(0.2, lost(), never_called);
  const auto joined = joiner.add(0.3, lost(), [](std::size_t index) {
    EXPECT_EQ(index, 1u);
    return forward(2);
  });
  EXPECT_EQ(joined.step.status, Status::kOk);
  const Pose expected = forward(1).cam2_from_cam1.inverse() * forward(2).cam2_from_cam1.inverse();
  EXPECT_LT((joined.world_from_cam.matrix() - expected.matrix()).norm(), 1e-12);
}

TEST(TrajectoryJoiner, GivesAnOldReferenceUpAndGoesOnFromTheFrameBefore) {
  TrajectoryJoiner joiner(0.5);
  joiner.start(0);
  const Pose last = joiner.add(0.1, forward(), never_called).world_from_cam;
  const auto still_lost = [](std::size_t) { return lost(); };
  for (double time = 0.2; time < 0.55; time += 0.1) joiner.add(time, lost(), still_lost);
  const auto joined = joiner.add(0.8, forward(), never_called);
  EXPECT_EQ(joined.step.status, Status::kOk);
  EXPECT_LT((joined.world_from_cam.matrix() - (last * forward().cam2_from_cam1.inverse()).matrix()).norm(),
            1e-12);
}

TEST(TrajectoryJoiner, KeepsRotationsOrthogonalOverLongRecordings) {
  TrajectoryJoiner joiner(1.0);
  joiner.start(0);
  TrajectoryJoiner::Joined joined;
  for (int i = 1; i <= 100000; ++i) joined = joiner.add(i, forward(), never_called);
  const Eigen::Matrix3d& R = joined.world_from_cam.R;
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace framewise
