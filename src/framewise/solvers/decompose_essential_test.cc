// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/decompose_essential.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <stdexcept>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

TEST(DecomposeEssential, EveryMotionIsARigidMotionOfTheSameEssentialMatrix) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose pose{so3_exp(random.normal3()), random.direction()};
    const Eigen::Matrix3d E = random.normal() * essential_from_pose(pose);
    for (const Pose& p : decompose_essential(E)) {
      EXPECT_LT((p.R.transpose() * p.R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      EXPECT_GT(p.R.determinant(), 0);
      const Eigen::Matrix3d back = essential_from_pose(p) * (E.norm() / std::sqrt(2.0));
      EXPECT_LT(std::min((back - E).norm(), (back + E).norm()), 1e-14 * E.norm());
    }
  }
}

TEST(DecomposeEssential, CheiralityFindsTheMotionThatMadeThePoints) {
  Random random(2);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry, Scene::kForward, Scene::kTinyBaseline}) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto problem = make_problem(scene, 6, random);
      const auto vote =
          choose_by_cheirality(-2.0 * essential_from_pose(problem.cam2_from_cam1), problem.x1, problem.x2);
      ASSERT_TRUE(vote.has_value());
      EXPECT_EQ(vote->in_front, 6u);
      EXPECT_LT(rotation_error(vote->cam2_from_cam1.R, problem.cam2_from_cam1.R), 1e-14);
      EXPECT_LT(direction_error(vote->cam2_from_cam1.t, problem.cam2_from_cam1.t), 1e-13);
    }
  }
}

TEST(DecomposeEssential, CheiralityVotesWithTheMajority) {
  Random random(3);
  auto problem = make_problem(Scene::kRandom, 9, random);
  for (int i = 0; i < 4; ++i) {  // the negated pair meets behind both cameras
    problem.x1[i] = -problem.x1[i];
    problem.x2[i] = -problem.x2[i];
  }
  const auto vote = choose_by_cheirality(essential_from_pose(problem.cam2_from_cam1), problem.x1, problem.x2);
  ASSERT_TRUE(vote.has_value());
  EXPECT_EQ(vote->in_front, 5u);
  EXPECT_LT(direction_error(vote->cam2_from_cam1.t, problem.cam2_from_cam1.t), 1e-13);
}

TEST(DecomposeEssential, InFrontAgreesWithTheDepths) {
  Random random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const auto problem = make_problem(Scene::kRandom, 1, random);
    const Pose& pose = problem.cam2_from_cam1;
    EXPECT_TRUE(in_front_of_both(pose, problem.x1[0], problem.x2[0]));
    EXPECT_FALSE(in_front_of_both(pose, -problem.x1[0], problem.x2[0]));
    EXPECT_FALSE(in_front_of_both(pose, problem.x1[0], -problem.x2[0]));
    EXPECT_FALSE(in_front_of_both({pose.R, -pose.t}, problem.x1[0], problem.x2[0]));
  }
}

TEST(DecomposeEssential, NearestEssentialIsNearerThanItsNeighbours) {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Matrix3d M = Eigen::Matrix3d::NullaryExpr([&](int, int) { return random.normal(); });
    const Eigen::Matrix3d E = nearest_essential(M);
    const auto distance = [&](const Eigen::Matrix3d& F) {  // at F's best scale
      return (M - F * (M.cwiseProduct(F).sum() / F.squaredNorm())).norm();
    };
    for (int k = 0; k < 20; ++k) {
      const Eigen::Matrix3d neighbour =
          so3_exp(1e-3 * random.normal3()) * E * so3_exp(1e-3 * random.normal3());
      EXPECT_LE(distance(E), distance(neighbour) + 1e-12);
    }
  }
}

TEST(DecomposeEssential, SaysNothingWhereNothingIsKnown) {
  const std::vector<Bearing> x(5, Bearing::UnitZ()), shorter(4, Bearing::UnitZ());
  Eigen::Matrix3d E = Eigen::Matrix3d::Zero();
  for (const Pose& p : decompose_essential(E)) EXPECT_TRUE(p.matrix().allFinite());
  E(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(choose_by_cheirality(E, x, x).has_value());
  EXPECT_FALSE(choose_by_cheirality(essential_from_pose({Eigen::Matrix3d::Identity(), {1, 0, 0}}), x, x));
  EXPECT_THROW(choose_by_cheirality(E, x, shorter), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
