// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/five_point_types.h"
#include "framewise/solvers/solver_laws_for_tests.h"

// What the five-point solvers promise beyond SolverLaws.
namespace framewise::testing {

inline std::array<Bearing, 5> five(const std::vector<Bearing>& x) { return {x[0], x[1], x[2], x[3], x[4]}; }

// Without translation nothing tells its direction.
inline Accuracy five_point_accuracy(Scene scene) {
  if (scene == Scene::kPureRotation) return {1e-6, kNotHere};
  return {1e-6, scene == Scene::kTinyBaseline ? 1e-2 : 1e-4};
}

template <typename Solver>
class FivePointLaws : public ::testing::Test {};

TYPED_TEST_SUITE_P(FivePointLaws);

TYPED_TEST_P(FivePointLaws, EverySolutionSolvesTheFiveEquationsToRounding) {
  Random random(21);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry, Scene::kPlanar, Scene::kForward}) {
    for (int trial = 0; trial < 200; ++trial) {
      const TwoViewProblem p = make_problem(scene, 5, random);
      for (const Eigen::Matrix3d& E : TypeParam::essential(p)) {
        for (int i = 0; i < 5; ++i) EXPECT_LT(std::abs(p.x2[i].dot(E * p.x1[i])), 1e-10);
        EXPECT_LT((2 * E * E.transpose() * E - (E * E.transpose()).trace() * E).norm(), 1e-13);
        EXPECT_LT(std::abs(E.determinant()), 1e-14);
        EXPECT_NEAR(E.norm(), std::sqrt(2.0), 1e-14);
      }
    }
  }
}

// Also for points that no motion made: the equations have ten solutions, real ones in pairs.
TYPED_TEST_P(FivePointLaws, RealSolutionsComeInPairs) {
  Random random(22);
  int odd = 0;
  for (int trial = 0; trial < 500; ++trial) {
    TwoViewProblem p = make_problem(Scene::kRandom, 5, random);
    for (Bearing& x : p.x2) x = (x + 0.02 * random.normal3()).normalized();
    odd += TypeParam::essential(p).size() % 2;
  }
  EXPECT_LE(odd, 5);
}

TYPED_TEST_P(FivePointLaws, PosesSeeAllFivePointsInFront) {
  Random random(23);
  for (int trial = 0; trial < 200; ++trial) {
    const TwoViewProblem p = make_problem(Scene::kRandom, 5, random);
    for (const Pose& pose : TypeParam::solve(p)) {
      EXPECT_NEAR(pose.t.norm(), 1, 1e-14);
      for (int i = 0; i < 5; ++i) EXPECT_TRUE(in_front_of_both(pose, p.x1[i], p.x2[i]));
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(FivePointLaws, EverySolutionSolvesTheFiveEquationsToRounding,
                            RealSolutionsComeInPairs, PosesSeeAllFivePointsInFront);

}  // namespace framewise::testing
