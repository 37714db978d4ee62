// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/essential_8pt.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/hypotheses.h"
#include "framewise/solvers/problems_for_tests.h"
#include "framewise/solvers/solver_laws_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

// The linear problem's condition number bounds what noise-free data give: 1e-16 times about (depth /
// baseline)^2.
double tolerance(Scene scene) {
  return scene == Scene::kTinyBaseline ? 1e-4 : scene == Scene::kRandom ? 1e-9 : 1e-7;
}

TEST(Essential8pt, IsExactOnExactBearingsFromEightToMany) {
  Random random(1);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry, Scene::kForward, Scene::kTinyBaseline}) {
    for (const int size : {8, 9, 20, 100}) {
      for (int trial = 0; trial < 100; ++trial) {
        const auto problem = make_problem(scene, size, random);
        const auto E = essential_8pt(problem.x1, problem.x2);
        ASSERT_TRUE(E.has_value());
        const auto vote = choose_by_cheirality(*E, problem.x1, problem.x2);
        ASSERT_TRUE(vote.has_value());
        EXPECT_LT(rotation_error(vote->cam2_from_cam1.R, problem.cam2_from_cam1.R), tolerance(scene))
            << name(scene) << ' ' << size;
      }
    }
  }
}

TEST(Essential8pt, WeightsCountAsRepeats) {
  Random random(2);
  auto problem = make_problem(Scene::kRandom, 12, random);
  for (Bearing& x : problem.x2) x = (x + 1e-3 * random.normal3()).normalized();
  std::vector<double> weights(12, 1.0);
  weights[3] = 3;
  const auto weighted = essential_8pt(problem.x1, problem.x2, weights);
  for (int k = 0; k < 2; ++k) {
    problem.x1.push_back(problem.x1[3]);
    problem.x2.push_back(problem.x2[3]);
  }
  const auto repeated = essential_8pt(problem.x1, problem.x2);
  ASSERT_TRUE(weighted && repeated);
  EXPECT_LT(std::min((*weighted - *repeated).norm(), (*weighted + *repeated).norm()), 1e-10);
}

TEST(Essential8pt, APointOfNoWeightHasNoSay) {
  Random random(3);
  auto problem = make_problem(Scene::kRandom, 12, random);
  problem.x2[5] = random.direction();
  std::vector<double> weights(12, 1.0);
  weights[5] = 0;
  const auto E = essential_8pt(problem.x1, problem.x2, weights);
  ASSERT_TRUE(E.has_value());
  const auto vote = choose_by_cheirality(*E, problem.x1, problem.x2);
  ASSERT_TRUE(vote.has_value());
  EXPECT_LT(rotation_error(vote->cam2_from_cam1.R, problem.cam2_from_cam1.R), 1e-9);
}

TEST(Essential8pt, NoiseGivesErrorsOfItsSize) {
  Random random(4);
  std::vector<double> errors;
  for (int trial = 0; trial < 100; ++trial) {
    auto problem = make_problem(Scene::kRandom, 100, random);
    for (Bearing& x : problem.x2) x = (x + 1e-3 * random.normal3()).normalized();
    const auto E = essential_8pt(problem.x1, problem.x2);
    ASSERT_TRUE(E.has_value());
    const auto vote = choose_by_cheirality(*E, problem.x1, problem.x2);
    ASSERT_TRUE(vote.has_value());
    errors.push_back(rotation_error(vote->cam2_from_cam1.R, problem.cam2_from_cam1.R));
  }
  std::nth_element(errors.begin(), errors.begin() + 50, errors.end());
  EXPECT_LT(errors[50], 5e-3);
}

TEST(Essential8pt, RefusesWhatItCannotUse) {
  Random random(5);
  const auto problem = make_problem(Scene::kRandom, 9, random);
  const std::span<const Bearing> x1 = problem.x1, x2 = problem.x2;
  EXPECT_THROW(essential_8pt(x1, x2.first(8)), std::invalid_argument);
  EXPECT_THROW(essential_8pt(x1.first(7), x2.first(7)), std::invalid_argument);
  EXPECT_THROW(essential_8pt(x1, x2, std::vector<double>(8, 1.0)), std::invalid_argument);
  for (const std::size_t size : {8u, 9u}) {
    std::vector<Bearing> bad(x1.begin(), x1.begin() + size);
    bad[2].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(essential_8pt(bad, x2.first(size)).has_value());
  }
}

TEST(Essential8pt, DegeneratePointsGiveSomeEssentialMatrixAndNoNaN) {
  Random random(6);
  for (const std::size_t size : {8u, 30u}) {
    std::vector<std::vector<Bearing>> degenerate(2, std::vector<Bearing>(size, Bearing(0.6, 0, 0.8)));
    for (std::size_t i = 0; i < size; ++i)
      degenerate[1][i] = Bearing(0.1 * i, 0.3, 1).normalized();  // a line
    for (const auto& x : degenerate) {
      const auto E = essential_8pt(x, x);
      ASSERT_TRUE(E.has_value());
      EXPECT_NEAR(E->norm(), std::sqrt(2.0), 1e-12);
    }
    for (const Scene scene : {Scene::kPureRotation, Scene::kPlanar}) {
      const auto problem = make_problem(scene, size, random);
      const auto E = essential_8pt(problem.x1, problem.x2);
      ASSERT_TRUE(E.has_value());
      for (std::size_t i = 0; i < size; ++i)
        EXPECT_TRUE(std::isfinite(problem.x2[i].dot(*E * problem.x1[i])));
    }
  }
}

// The minimal case, with the motion chosen by cheirality.
struct Essential8ptMinimal {
  static constexpr std::size_t kPoints = 8;
  // A plane leaves a 3-dimensional space of matrices with x2' E x1 = 0, motion without translation likewise:
  // the linear problem has no single answer there.
  static testing::Accuracy accuracy(Scene scene) {
    if (scene == Scene::kPlanar || scene == Scene::kPureRotation)
      return {testing::kNotHere, testing::kNotHere};
    if (scene == Scene::kTinyBaseline) return {1e-5, 0.1};
    return {1e-7, 1e-5};
  }
  static Hypotheses<Pose, 1> solve(const testing::TwoViewProblem& problem) {
    Hypotheses<Pose, 1> poses;
    if (const auto E = essential_8pt(problem.x1, problem.x2)) {
      if (const auto vote = choose_by_cheirality(*E, problem.x1, problem.x2))
        poses.push_back(vote->cam2_from_cam1);
    }
    return poses;
  }
};

}  // namespace

namespace testing {
INSTANTIATE_TYPED_TEST_SUITE_P(Essential8pt, SolverLaws, Essential8ptMinimal);
}  // namespace testing
}  // namespace framewise
