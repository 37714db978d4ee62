// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_eigensolver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

std::vector<Bearing> turned(std::vector<Bearing> x, const Eigen::Matrix3d& Q) {
  for (Bearing& b : x) b = Q * b;
  return x;
}

// Six points have false minima whose cost, at a baseline of 1e-4, is within rounding of zero.
int allowed_per_cent(Scene scene, std::size_t n) {
  if (n >= 10) return 0;
  return scene == Scene::kTinyBaseline ? 5 : 1;
}

class EigensolverLaws : public ::testing::TestWithParam<std::tuple<Scene, std::size_t>> {};

TEST_P(EigensolverLaws, ExactOnExactDataFromNoGuess) {
  const auto [scene, n] = GetParam();
  Random random(1);
  int failures = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto p = make_problem(scene, n, random);
    const auto s = rotation_eigensolver(p.x1, p.x2);
    ASSERT_TRUE(s);
    EXPECT_LT(s->eigenvalues[0], 1e-12);
    if (scene == Scene::kPlanar) continue;  // a plane has a second motion that fits exactly
    failures += !(rotation_error(s->R, p.cam2_from_cam1.R) < 1e-5 &&
                  direction_error(s->t, p.cam2_from_cam1.t) < 1e-3);
  }
  EXPECT_LE(failures, allowed_per_cent(scene, n) * 3);
}

TEST_P(EigensolverLaws, TurnsWithTheCamerasAndInvertsWhenSwapped) {
  const auto [scene, n] = GetParam();
  if (scene == Scene::kPlanar) GTEST_SKIP() << "a plane has two motions that fit exactly";
  Random random(2);
  int failures = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto p = make_problem(scene, n, random);
    const Eigen::Matrix3d Q1 = so3_exp(3 * random.direction()), Q2 = so3_exp(3 * random.direction());
    const auto s = rotation_eigensolver(turned(p.x1, Q1), turned(p.x2, Q2));
    const auto back = rotation_eigensolver(p.x2, p.x1);
    ASSERT_TRUE(s && back);
    failures += !(rotation_error(s->R, Q2 * p.cam2_from_cam1.R * Q1.transpose()) < 1e-5 &&
                  direction_error(s->t, Q2 * p.cam2_from_cam1.t) < 1e-3);
    failures += !(rotation_error(back->R, p.cam2_from_cam1.R.transpose()) < 1e-5 &&
                  direction_error(back->t, p.cam2_from_cam1.inverse().t) < 1e-3);
  }
  EXPECT_LE(failures, allowed_per_cent(scene, n) * 2);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EigensolverLaws,
                         ::testing::Combine(::testing::Values(Scene::kRandom, Scene::kOdometry,
                                                              Scene::kPlanar, Scene::kForward,
                                                              Scene::kTinyBaseline),
                                            ::testing::Values(6, 8, 10, 100)),
                         [](const auto& info) {
                           return testing::name(std::get<0>(info.param)) +
                                  std::to_string(std::get<1>(info.param));
                         });

double cost(const testing::TwoViewProblem& p, const std::vector<double>& weights, const Eigen::Matrix3d& R,
            const Eigen::Vector3d& t) {
  double sum = 0;
  for (std::size_t i = 0; i < p.x1.size(); ++i) {
    const double residual = t.dot(p.x2[i].cross(R * p.x1[i]));
    sum += weights[i] * residual * residual;
  }
  return sum;
}

TEST(Eigensolver, NoNeighbourFitsNoisyDataBetterAndSeldomDoesTheTruth) {
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry}) {
    Random random(3);
    int beaten_by_truth = 0;
    for (int trial = 0; trial < 200; ++trial) {
      auto p = make_problem(scene, 10, random);
      std::vector<double> weights;
      for (Bearing& x : p.x2) {
        x = (x + 5e-4 * random.normal3()).normalized();
        weights.push_back(random.uniform(0.5, 2));
      }
      const auto s = rotation_eigensolver(p.x1, p.x2, {}, weights);
      ASSERT_TRUE(s);
      EXPECT_NEAR(cost(p, weights, s->R, s->t), s->eigenvalues[0], 1e-12);
      for (int k = 0; k < 10; ++k) {
        const Eigen::Matrix3d R = so3_exp(1e-4 * random.direction()) * s->R;
        const Eigen::Vector3d t = (s->t + 1e-4 * random.direction()).normalized();
        EXPECT_LT(s->eigenvalues[0], cost(p, weights, R, t) + 1e-12);
      }
      beaten_by_truth +=
          cost(p, weights, p.cam2_from_cam1.R, p.cam2_from_cam1.t.normalized()) < s->eigenvalues[0];
    }
    EXPECT_LE(beaten_by_truth, 1) << testing::name(scene);
  }
}

TEST(Eigensolver, AWrongGuessDoesNotMislead) {
  Random random(4);
  int failures = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = make_problem(trial % 2 ? Scene::kOdometry : Scene::kRandom, 10, random);
    const auto s = rotation_eigensolver(p.x1, p.x2, Eigen::Matrix3d(so3_exp(3 * random.direction())));
    ASSERT_TRUE(s);
    failures += !(rotation_error(s->R, p.cam2_from_cam1.R) < 1e-5);
  }
  EXPECT_LE(failures, 1);
}

TEST(Eigensolver, PureRotationGivesTheRotationAndAMiddleEigenvalueOfNothing) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const auto p = make_problem(Scene::kPureRotation, 10, random);
    const auto s = rotation_eigensolver(p.x1, p.x2);
    ASSERT_TRUE(s);
    EXPECT_LT(rotation_error(s->R, p.cam2_from_cam1.R), 1e-6);
    EXPECT_LT(s->eigenvalues[1], 1e-12);
    EXPECT_NEAR(s->t.norm(), 1, 1e-9);
  }
}

TEST(Eigensolver, DegenerateDataGiveFiniteAnswersOrNone) {
  Random random(6);
  for (int trial = 0; trial < 50; ++trial) {
    auto p = make_problem(Scene::kRandom, 10, random);
    for (int i = 2; i < 10; ++i) p.x1[i] = p.x1[i % 2], p.x2[i] = p.x2[i % 2];
    if (const auto s = rotation_eigensolver(p.x1, p.x2)) {
      EXPECT_TRUE(s->R.allFinite() && s->t.allFinite());
    }
    for (int i = 0; i < 10; ++i) {  // points of one line in space
      const Eigen::Vector3d X = p.X1[0] + 0.1 * i * (p.X1[9] - p.X1[0]);
      p.x1[i] = X.normalized(), p.x2[i] = (p.cam2_from_cam1 * X).normalized();
    }
    if (const auto s = rotation_eigensolver(p.x1, p.x2)) {
      EXPECT_TRUE(s->R.allFinite() && s->t.allFinite());
    }
  }
  const std::vector<Bearing> same(10, Bearing::UnitZ());
  EXPECT_FALSE(rotation_eigensolver(same, same));
}

TEST(Eigensolver, IsEmptyOnTooFewAndNaN) {
  Random random(7);
  auto p = make_problem(Scene::kRandom, 10, random);
  EXPECT_FALSE(rotation_eigensolver({p.x1.data(), 4}, {p.x2.data(), 4}));
  p.x1[3].setConstant(NAN);
  EXPECT_FALSE(rotation_eigensolver(p.x1, p.x2));
}

TEST(Eigensolver, RefusesSizesThatDiffer) {
  const std::vector<Bearing> x(10, Bearing::UnitZ());
  EXPECT_THROW(rotation_eigensolver(x, {x.data(), 9}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
