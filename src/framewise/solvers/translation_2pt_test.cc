// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/translation_2pt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::make_problem;
using testing::Random;
using testing::Scene;

using Pair = std::array<Bearing, 2>;

class Translation2ptLaws : public ::testing::TestWithParam<Scene> {};

TEST_P(Translation2ptLaws, ExactOnExactData) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const auto p = make_problem(GetParam(), 2, random);
    const Pair x1{p.x1[0], p.x1[1]}, x2{p.x2[0], p.x2[1]};
    // What a rounding error of the normals can do.
    const Eigen::Matrix3d& R = p.cam2_from_cam1.R;
    const Eigen::Vector3d n0 = (R * x1[0]).cross(x2[0]), n1 = (R * x1[1]).cross(x2[1]);
    const double tolerance = 1e-14 * (n0.norm() + n1.norm()) / n0.cross(n1).norm();
    const auto t = translation_2pt(x1, x2, R);
    ASSERT_TRUE(t);
    EXPECT_NEAR(t->norm(), 1, 1e-14);
    EXPECT_LT(direction_error(*t, p.cam2_from_cam1.t), tolerance);
    // Views swapped
    const auto back = translation_2pt(x2, x1, R.transpose());
    ASSERT_TRUE(back);
    EXPECT_LT(direction_error(*back, p.cam2_from_cam1.inverse().t), tolerance);
  }
}

TEST_P(Translation2ptLaws, TurnsWithTheCameras) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const auto p = make_problem(GetParam(), 2, random);
    const Eigen::Matrix3d Q1 = so3_exp(2 * random.direction()), Q2 = so3_exp(2 * random.direction());
    const auto t = translation_2pt({p.x1[0], p.x1[1]}, {p.x2[0], p.x2[1]}, p.cam2_from_cam1.R);
    const auto turned = translation_2pt({Q1 * p.x1[0], Q1 * p.x1[1]}, {Q2 * p.x2[0], Q2 * p.x2[1]},
                                        Q2 * p.cam2_from_cam1.R * Q1.transpose());
    ASSERT_TRUE(t && turned);
    EXPECT_LT(direction_error(*turned, Q2 * *t), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Translation2ptLaws,
                         ::testing::Values(Scene::kRandom, Scene::kOdometry, Scene::kPlanar, Scene::kForward,
                                           Scene::kTinyBaseline),
                         [](const auto& info) { return testing::name(info.param); });

TEST(Translation2pt, IsEmptyWithoutParallax) {
  Random random(3);
  for (int trial = 0; trial < 500; ++trial) {
    const auto p = make_problem(Scene::kPureRotation, 2, random);
    EXPECT_FALSE(translation_2pt({p.x1[0], p.x1[1]}, {p.x2[0], p.x2[1]}, p.cam2_from_cam1.R));
  }
}

TEST(Translation2pt, IsEmptyOnRepeatedPointsAndNaN) {
  Random random(4);
  const auto p = make_problem(Scene::kRandom, 2, random);
  EXPECT_FALSE(translation_2pt({p.x1[0], p.x1[0]}, {p.x2[0], p.x2[0]}, p.cam2_from_cam1.R));
  const Bearing nan = Bearing::Constant(NAN);
  EXPECT_FALSE(translation_2pt({p.x1[0], nan}, {p.x2[0], p.x2[1]}, p.cam2_from_cam1.R));
}

}  // namespace
}  // namespace framewise
