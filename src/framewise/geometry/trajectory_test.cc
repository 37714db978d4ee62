// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/trajectory.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// Turns evenly about z at 1 rad/s and moves evenly along x at 2 m/s: what interpolation must reproduce.
Pose even_motion(double time) { return {so3_exp({0, 0, time}), {2 * time, 0, 1}}; }

Trajectory sampled(std::initializer_list<double> times) {
  Trajectory trajectory;
  for (const double time : times) trajectory.add(time, even_motion(time));
  return trajectory;
}

TEST(PoseAt, IsExactForEvenMotion) {
  const Trajectory trajectory = sampled({0, 0.1, 0.25, 0.3});
  for (const double time : {0.0, 0.03, 0.1, 0.2, 0.2999, 0.3}) {
    const auto pose = pose_at(trajectory, time, 1.0);
    ASSERT_TRUE(pose) << time;
    EXPECT_LT((pose->matrix() - even_motion(time).matrix()).norm(), 1e-14) << time;
  }
}

TEST(PoseAt, KnowsNothingOutsideAndAcrossHoles) {
  const Trajectory trajectory = sampled({0, 0.1, 0.5});
  EXPECT_FALSE(pose_at(trajectory, -0.01, 1.0));
  EXPECT_FALSE(pose_at(trajectory, 0.51, 1.0));
  EXPECT_FALSE(pose_at(trajectory, 0.3, 0.2));
  EXPECT_TRUE(pose_at(trajectory, 0.3, 0.5));
  EXPECT_TRUE(pose_at(trajectory, 0.5, 0.2));  // a pose of its own needs no neighbours
  EXPECT_FALSE(pose_at(Trajectory(), 0, 1.0));
}

TEST(PathLength, IsTheSumOfTheSteps) {
  EXPECT_NEAR(path_length(sampled({0, 0.1, 0.5, 2})), 4, 1e-14);
  EXPECT_EQ(path_length(sampled({1})), 0);
  EXPECT_EQ(path_length(Trajectory()), 0);
}

// Conventions that the whole library stands on.
TEST(Conventions, AMotionMapsPointsOfCamera1ToCamera2) {
  // Camera 2 stands 1 m to the right of camera 1: what is ahead of camera 1 is left and ahead for camera 2.
  const Pose world_from_cam1, world_from_cam2{Eigen::Matrix3d::Identity(), {1, 0, 0}};
  const Pose cam2_from_cam1 = world_from_cam2.inverse() * world_from_cam1;
  EXPECT_EQ(cam2_from_cam1 * Eigen::Vector3d(0, 0, 5), Eigen::Vector3d(-1, 0, 5));
}

TEST(Conventions, TheIncrementOfATrajectoryIsTheInverseOfTheMotion) {
  const Pose world_from_cam1 = even_motion(0.3), world_from_cam2 = even_motion(0.7);
  const Pose cam2_from_cam1 = world_from_cam2.inverse() * world_from_cam1;
  EXPECT_LT(((world_from_cam1 * cam2_from_cam1.inverse()).matrix() - world_from_cam2.matrix()).norm(), 1e-14);
}

TEST(Conventions, QuaternionsAreHamilton) {
  // A quarter turn about z takes x to y: Hamilton's (0, 0, sin 45, cos 45), not its conjugate.
  const Pose turn =
      Pose::from_quaternion(Eigen::Quaterniond(std::sqrt(0.5), 0, 0, std::sqrt(0.5)), {0, 0, 0});
  EXPECT_LT((turn * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace framewise
