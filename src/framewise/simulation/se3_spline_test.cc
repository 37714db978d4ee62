// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/se3_spline.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/geometry/so3.h"
#include "framewise/simulation/random.h"

namespace framewise {
namespace {

using Eigen::Vector3d;

// Any motion at uneven times, with turns of up to 150 degrees from one pose to the next.
Trajectory wild_poses() {
  Random random(5);
  const auto vector = [&](double size) {
    return Vector3d(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  };
  Trajectory poses;
  Pose pose;
  double time = 2;
  for (int i = 0; i < 12; ++i) {
    poses.add(time, pose);
    time += random.uniform(0.1, 0.9);
    pose = {pose.R * so3_exp(vector(1.5)), pose.t + vector(2)};
  }
  return poses;
}

TEST(Se3Spline, GoesThroughEveryPose) {
  const Trajectory poses = wild_poses();
  const Se3Spline spline(poses);
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT((spline(poses.times[i]).world_from_cam.matrix() - poses.world_from_cam[i].matrix()).norm(),
              1e-12);
}

TEST(Se3Spline, VelocityAccelerationAndRateAreItsDerivatives) {
  const Se3Spline spline(wild_poses());
  constexpr double h = 1e-6;
  for (double t = spline.begin() + 0.01; t < spline.end() - 0.01; t += 0.0137) {
    const Motion before = spline(t - h), here = spline(t), after = spline(t + h);
    EXPECT_LT(((after.world_from_cam.t - before.world_from_cam.t) / (2 * h) - here.velocity).norm(), 1e-5);
    EXPECT_LT(((after.velocity - before.velocity) / (2 * h) - here.acceleration).norm(), 2e-2);
    const Vector3d turn = so3_log(before.world_from_cam.R.transpose() * after.world_from_cam.R) / (2 * h);
    EXPECT_LT((turn - here.angular_rate).norm(), 1e-4) << "at " << t;
  }
}

// On both sides of each pose; the angular acceleration by one-sided differences.
TEST(Se3Spline, IsTwiceContinuouslyDifferentiableAtThePoses) {
  const Trajectory poses = wild_poses();
  const Se3Spline spline(poses);
  constexpr double h = 1e-7, e = 1e-10;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    const double t = poses.times[i];
    const Motion before = spline(t - e), after = spline(t + e);
    EXPECT_LT((after.velocity - before.velocity).norm(), 1e-6);
    EXPECT_LT((after.acceleration - before.acceleration).norm(), 1e-5);
    EXPECT_LT((after.angular_rate - before.angular_rate).norm(), 1e-6);
    const Vector3d slope_before = (before.angular_rate - spline(t - h).angular_rate) / (h - e),
                   slope_after = (spline(t + h).angular_rate - after.angular_rate) / (h - e);
    EXPECT_LT((slope_after - slope_before).norm(), 1e-2) << "at pose " << i;
  }
}

TEST(Se3Spline, KeepsSteadyAcceleratedMotionAsItIs) {
  Trajectory poses;
  const Vector3d v(1, -2, 0.5), a(0.3, 0.2, -0.9), w(0.2, 0.5, -0.4);
  const auto pose = [&](double t) { return Pose{so3_exp(t * w), v * t + 0.5 * a * t * t}; };
  for (const double t : {0.0, 0.4, 1.1, 1.3, 2.0}) poses.add(t, pose(t));
  const Se3Spline spline(poses);
  for (double t = 0; t <= 2; t += 0.05) {
    const Motion motion = spline(t);
    EXPECT_LT((motion.world_from_cam.matrix() - pose(t).matrix()).norm(), 1e-12);
    EXPECT_LT((motion.velocity - (v + a * t)).norm(), 1e-11);
    EXPECT_LT((motion.acceleration - a).norm(), 1e-10);
    EXPECT_LT((motion.angular_rate - w).norm(), 1e-11);
  }
}

TEST(Se3Spline, OfTwoPosesIsTheStraightScrew) {
  Trajectory poses;
  poses.add(1, {});
  poses.add(3, {so3_exp({0, 0, 0.8}), {2, 0, 0}});
  const Motion middle = Se3Spline(poses)(2);
  EXPECT_LT((middle.world_from_cam.t - Vector3d(1, 0, 0)).norm(), 1e-14);
  EXPECT_LT((middle.angular_rate - Vector3d(0, 0, 0.4)).norm(), 1e-14);
}

TEST(Se3Spline, RefusesPosesThatMakeNoMotion) {
  Trajectory poses;
  EXPECT_THROW(Se3Spline{poses}, std::invalid_argument);
  poses.add(1, {});
  EXPECT_THROW(Se3Spline{poses}, std::invalid_argument);
  poses.add(1, {});
  EXPECT_THROW(Se3Spline{poses}, std::invalid_argument);
  poses.times[1] = 2;
  const Se3Spline spline(poses);
  EXPECT_THROW(spline(0.9), std::invalid_argument);
  EXPECT_THROW(spline(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
