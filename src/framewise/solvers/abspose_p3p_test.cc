// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/abspose_p3p.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

using Bearings = std::array<Bearing, 3>;
using Points = std::array<Eigen::Vector3d, 3>;

// Distance of the nearest solution (rad; translation relative to the points' distance of about 5 m).
double error(const Hypotheses<Pose, 4>& poses, const Pose& truth) {
  double best = M_PI;
  for (const Pose& pose : poses)
    best = std::min(best, std::max(rotation_error(pose.R, truth.R), (pose.t - truth.t).norm() / 5));
  return best;
}

class P3pLaws : public ::testing::TestWithParam<Scene> {};

TEST_P(P3pLaws, ExactOnExactData) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto p = make_problem(GetParam(), 3, random);
    const auto poses = abspose_p3p({p.x2[0], p.x2[1], p.x2[2]}, {p.X1[0], p.X1[1], p.X1[2]});
    EXPECT_LT(error(poses, p.cam2_from_cam1), 1e-6);
  }
}

TEST_P(P3pLaws, EverySolutionIsARotationThatReprojectsInFrontOfTheCamera) {
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const auto p = make_problem(GetParam(), 3, random);
    for (const Pose& pose : abspose_p3p({p.x2[0], p.x2[1], p.x2[2]}, {p.X1[0], p.X1[1], p.X1[2]})) {
      EXPECT_LT((pose.R * pose.R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-10);
      EXPECT_GT(pose.R.determinant(), 0);
      for (int i = 0; i < 3; ++i) EXPECT_LT(testing::direction_error(pose * p.X1[i], p.x2[i]), 1e-6);
    }
  }
}

TEST_P(P3pLaws, MovesWithCameraAndWorld) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = make_problem(GetParam(), 3, random);
    const Eigen::Matrix3d Q = so3_exp(2 * random.direction());
    const Pose world2_from_world{so3_exp(2 * random.direction()), random.normal3()};
    Bearings x;
    Points X;
    for (int i = 0; i < 3; ++i) x[i] = Q * p.x2[i], X[i] = world2_from_world * p.X1[i];
    EXPECT_LT(error(abspose_p3p(x, X), Pose{Q, {0, 0, 0}} * p.cam2_from_cam1 * world2_from_world.inverse()),
              1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, P3pLaws, ::testing::ValuesIn(testing::kAllScenes),
                         [](const auto& info) { return testing::name(info.param); });

TEST(P3p, SolvesSymmetricTriangles) {
  // Equal sides seen straight on: coefficients of the conics vanish.
  for (const double depth : {1.0, 3.0, 10.0}) {
    const Points X{{{1, 0, 0}, {-0.5, std::sqrt(0.75), 0}, {-0.5, -std::sqrt(0.75), 0}}};
    const Pose truth{Eigen::Matrix3d::Identity(), {0, 0, depth}};
    Bearings x;
    for (int i = 0; i < 3; ++i) x[i] = (truth * X[i]).normalized();
    EXPECT_LT(error(abspose_p3p(x, X), truth), 1e-6) << depth;
  }
}

TEST(P3p, IsEmptyOnCollinearRepeatedAndNaNPoints) {
  const Bearings x{Bearing(0.1, 0, 1).normalized(), Bearing(0, 0.1, 1).normalized(),
                   Bearing(-0.1, 0.2, 1).normalized()};
  EXPECT_TRUE(abspose_p3p(x, {{{0, 0, 1}, {1, 1, 2}, {2, 2, 3}}}).empty());
  EXPECT_TRUE(abspose_p3p(x, {{{0, 0, 1}, {0, 0, 1}, {2, 2, 3}}}).empty());
  EXPECT_TRUE(abspose_p3p(x, {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}).empty());
  EXPECT_TRUE(abspose_p3p(x, {{{NAN, 0, 1}, {1, 0, 1}, {2, 2, 3}}}).empty());
  EXPECT_TRUE(abspose_p3p({x[0], Bearing::Constant(NAN), x[2]}, {{{0, 0, 1}, {1, 0, 1}, {2, 2, 3}}}).empty());
}

// Bearings with noise of flat triangles need not belong to any triangle of their sides and area.
TEST(P3p, FlatTrianglesWithNoiseGiveRotationsOrNone) {
  Random random(7);
  int poses = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const double flat = std::pow(10, random.uniform(-7, -0.5));
    Points X;
    X[0] = Eigen::Vector3d(0, 0, 4) + random.normal3();
    X[1] = X[0] + random.normal3();
    X[2] = X[0] + random.uniform(-2, 2) * (X[1] - X[0]) + flat * random.normal3();
    Bearings x;
    for (int i = 0; i < 3; ++i) x[i] = (X[i] + 0.01 * random.normal3()).normalized();
    for (const Pose& pose : abspose_p3p(x, X)) {
      ++poses;
      EXPECT_LT((pose.R * pose.R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-8);
    }
  }
  EXPECT_GT(poses, 1000);
}

TEST(P3p, RepeatedOrCollinearBearingsGiveFinitePosesOrNone) {
  const Points X{{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}}};
  const Bearing a = Bearing(0.1, 0, 1).normalized(), b = Bearing(0.3, 0, 1).normalized();
  const Bearing c = Bearing(-0.2, 0, 1).normalized();
  for (const Bearings& x : {Bearings{a, a, a}, Bearings{a, a, b}, Bearings{a, b, b}, Bearings{a, b, c}})
    for (const Pose& pose : abspose_p3p(x, X)) EXPECT_TRUE(pose.matrix().allFinite());
}

}  // namespace
}  // namespace framewise
