// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/pose_convention.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Eigen::Vector3d;

// A hand-held camera that turns about all axes and walks.
Pose handheld(double t) {
  return {so3_exp({0.5 * std::sin(t), 0.8 * t, 0.4 * std::cos(1.3 * t)}),
          {std::sin(0.7 * t), 0.2 * std::cos(t), 0.6 * t}};
}

// A car: level, turning left and right as it drives.
Pose car(double t) {
  const double heading = 0.3 * std::sin(0.5 * t);
  return {so3_exp({0, heading, 0}), {0.1 * t * t, 0, 8 * t}};
}

using Path = Pose (*)(double);
using Writing = Pose (*)(const Pose& world_from_cam);

Pose as_it_is(const Pose& pose) { return pose; }
Pose scalar_first(const Pose& pose) {  // written w x y z, read x y z w
  const Eigen::Quaterniond q = pose.quaternion();
  return Pose::from_quaternion(Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()), pose.t);
}
Pose scalar_last(const Pose& pose) {  // written x y z w, read w x y z
  const Eigen::Quaterniond q = pose.quaternion();
  return Pose::from_quaternion(Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()), pose.t);
}
Pose inverted(const Pose& pose) { return pose.inverse(); }
Pose of_body(const Pose& pose) {  // x forward, y left, z up, 0.1 m beside the camera
  Eigen::Matrix3d cam_from_body;
  cam_from_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return pose * Pose{cam_from_body, {0.1, 0, 0}};
}
Pose nonsense(const Pose& pose) {
  return {so3_exp(so3_log(pose.R).cwiseProduct(Vector3d(-1.7, 2.3, 0.4))), -2 * pose.t};
}

ConventionJudgement judged(Path path, Writing written, double noise = 0.005) {
  std::vector<ObservedMotion> motions;
  for (int i = 0; i < 20; ++i) {
    const double t1 = 0.2 * i, t2 = t1 + 0.15;
    Pose cam2_from_cam1 = path(t2).inverse() * path(t1);
    cam2_from_cam1.R =
        cam2_from_cam1.R * so3_exp(noise * Vector3d(std::sin(9.0 * i), std::cos(7.0 * i), std::sin(5.0 * i)));
    cam2_from_cam1.t.normalize();
    motions.push_back({written(path(t1)), written(path(t2)), cam2_from_cam1, 0.05});
  }
  return judge_convention(motions);
}

TEST(PoseConvention, TellsEachWayOfWriting) {
  EXPECT_EQ(judged(handheld, as_it_is).convention, PoseConvention::kAsRead);
  EXPECT_EQ(judged(handheld, scalar_first).convention, PoseConvention::kScalarFirst);
  EXPECT_EQ(judged(handheld, scalar_last).convention, PoseConvention::kScalarLast);
  EXPECT_EQ(judged(handheld, inverted).convention, PoseConvention::kInverse);
  EXPECT_EQ(judged(handheld, of_body).convention, PoseConvention::kBodyFrame);
  EXPECT_EQ(judged(handheld, nonsense).convention, PoseConvention::kNone);
}

TEST(PoseConvention, TellsThemForACarAsWell) {
  EXPECT_EQ(judged(car, as_it_is).convention, PoseConvention::kAsRead);
  EXPECT_EQ(judged(car, inverted).convention, PoseConvention::kInverse);
  EXPECT_EQ(judged(car, of_body).convention, PoseConvention::kBodyFrame);
}

TEST(PoseConvention, TellsABodyThatOnlyDrivesStraightAhead) {
  const Path straight = [](double t) { return Pose{so3_exp({0, 0.002 * t, 0}), {0.01 * t * t, 0, 8 * t}}; };
  EXPECT_EQ(judged(straight, as_it_is).convention, PoseConvention::kAsRead);
  EXPECT_EQ(judged(straight, of_body).convention, PoseConvention::kBodyFrame);
}

TEST(PoseConvention, FindsTheBodysRotation) {
  const ConventionJudgement judgement = judged(handheld, of_body, 0);
  Eigen::Matrix3d cam_from_body;
  cam_from_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  EXPECT_LT(rotation_angle(judgement.cam_from_body.transpose() * cam_from_body), 1e-6);
}

TEST(PoseConvention, PermutedQuaternionsKeepTheirAngles) {
  for (int i = 0; i < 10; ++i) {
    const Pose a = handheld(0.2 * i), b = handheld(0.2 * i + 0.1);
    EXPECT_NEAR(rotation_angle(scalar_first(a).R.transpose() * scalar_first(b).R),
                rotation_angle(a.R.transpose() * b.R), 1e-9);
  }
}

TEST(PoseConvention, SaysNothingWithoutMotion) {
  EXPECT_EQ(judge_convention({}).convention, PoseConvention::kUntold);
  std::vector<ObservedMotion> still(20);
  EXPECT_EQ(judge_convention(still).convention, PoseConvention::kUntold);
  still.resize(3);
  for (ObservedMotion& motion : still) motion.cam2_from_cam1.R = so3_exp({0, 0.2, 0});
  EXPECT_EQ(judge_convention(still).convention, PoseConvention::kUntold) << "three motions are too few";
}

}  // namespace
}  // namespace framewise
