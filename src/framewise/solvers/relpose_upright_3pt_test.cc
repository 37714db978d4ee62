// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relpose_upright_3pt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

using Three = std::array<Bearing, 3>;

Three three(const std::vector<Bearing>& x, const Eigen::Matrix3d& Q = Eigen::Matrix3d::Identity()) {
  return {Q * x[0], Q * x[1], Q * x[2]};
}

double error(const Hypotheses<Pose, 4>& poses, const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
  double best = M_PI;
  for (const Pose& pose : poses)
    best = std::min(best, std::max(rotation_error(pose.R, R), direction_error(pose.t, t)));
  return best;
}

// Frames of camera 1 and 2 turned so that their y axes are gravity, given its direction in camera 1.
struct Levelled {
  Eigen::Matrix3d level1, level2;
  Levelled(const Pose& cam2_from_cam1, const Bearing& gravity1) {
    const auto level = [](const Bearing& gravity) {
      return Eigen::Quaterniond::FromTwoVectors(gravity, Bearing::UnitY()).toRotationMatrix();
    };
    level1 = level(gravity1), level2 = level(cam2_from_cam1.R * gravity1);
  }
};

class Upright3ptLaws : public ::testing::TestWithParam<Scene> {};

TEST_P(Upright3ptLaws, ExactOnExactDataAndSwapped) {
  Random random(1);
  int failures = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto p = make_problem(GetParam(), 3, random);
    const Levelled l(p.cam2_from_cam1, random.direction());
    const Eigen::Matrix3d R = l.level2 * p.cam2_from_cam1.R * l.level1.transpose();
    const Eigen::Vector3d t = l.level2 * p.cam2_from_cam1.t;
    const Three x1 = three(p.x1, l.level1), x2 = three(p.x2, l.level2);
    failures += !(error(relpose_upright_3pt(x1, x2), R, t) < 1e-4);
    failures += !(error(relpose_upright_3pt(x2, x1), R.transpose(), -R.transpose() * t) < 1e-4);
  }
  EXPECT_LE(failures, 2);
}

TEST_P(Upright3ptLaws, GravityInTheCamerasOwnFramesIsTheSameProblem) {
  Random random(2);
  int failures = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto p = make_problem(GetParam(), 3, random);
    const Bearing gravity1 = random.direction(), gravity2 = p.cam2_from_cam1.R * gravity1;
    const auto poses = relpose_upright_3pt(three(p.x1), three(p.x2), gravity1, gravity2);
    failures += !(error(poses, p.cam2_from_cam1.R, p.cam2_from_cam1.t) < 1e-4);
    for (const Pose& pose : poses) {
      EXPECT_LT(direction_error(pose.R * gravity1, gravity2), 1e-12);
      EXPECT_NEAR(pose.t.norm(), 1, 1e-12);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(pose.t.dot(p.x2[i].cross(pose.R * p.x1[i])), 0, 1e-7);
    }
  }
  EXPECT_LE(failures, 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Upright3ptLaws,
                         ::testing::Values(Scene::kRandom, Scene::kOdometry, Scene::kPlanar, Scene::kForward,
                                           Scene::kTinyBaseline),
                         [](const auto& info) { return testing::name(info.param); });

TEST(Upright3pt, DegenerateDataGiveFinitePosesOrNone) {
  Random random(3);
  const auto expect_finite = [](const Hypotheses<Pose, 4>& poses) {
    for (const Pose& pose : poses) EXPECT_TRUE(pose.matrix().allFinite());
  };
  for (int trial = 0; trial < 200; ++trial) {
    const auto still = make_problem(Scene::kPureRotation, 3, random);
    const Levelled l(still.cam2_from_cam1, random.direction());
    expect_finite(relpose_upright_3pt(three(still.x1, l.level1), three(still.x2, l.level2)));
    auto p = make_problem(Scene::kRandom, 3, random);
    expect_finite(relpose_upright_3pt(three(p.x1), three(p.x1)));
    expect_finite(relpose_upright_3pt({p.x1[0], p.x1[0], p.x1[1]}, {p.x2[0], p.x2[0], p.x2[1]}));
    expect_finite(relpose_upright_3pt({p.x1[0], p.x1[0], p.x1[0]}, {p.x2[0], p.x2[0], p.x2[0]}));
    const Bearing middle1 = (p.X1[0] + p.X1[1]).normalized();
    const Bearing middle2 = (p.X2[0] + p.X2[1]).normalized();
    expect_finite(relpose_upright_3pt({p.x1[0], p.x1[1], middle1}, {p.x2[0], p.x2[1], middle2}));
  }
  const Bearing nan = Bearing::Constant(NAN), z = Bearing::UnitZ();
  EXPECT_TRUE(relpose_upright_3pt({nan, z, z}, {z, z, z}).empty());
  EXPECT_TRUE(relpose_upright_3pt({z, z, z}, {z, z, z}).empty());
}

}  // namespace
}  // namespace framewise
