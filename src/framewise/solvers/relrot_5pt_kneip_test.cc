// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relrot_5pt_kneip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framewise/solvers/problems_for_tests.h"
#include "framewise/solvers/translation_npt.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

using Rotations = Hypotheses<Eigen::Matrix3d, 20>;
using Five = std::array<Bearing, 5>;

Five five(const std::vector<Bearing>& x, const Eigen::Matrix3d& Q = Eigen::Matrix3d::Identity()) {
  return {Q * x[0], Q * x[1], Q * x[2], Q * x[3], Q * x[4]};
}

double error(const Rotations& rotations, const Eigen::Matrix3d& truth) {
  double best = M_PI;
  for (const Eigen::Matrix3d& R : rotations) best = std::min(best, rotation_error(R, truth));
  return best;
}

void expect_finite_rotations(const Rotations& rotations) {
  for (const Eigen::Matrix3d& R : rotations) {
    ASSERT_TRUE(R.allFinite());
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_GT(R.determinant(), 0);
  }
}

class Kneip5ptLaws : public ::testing::TestWithParam<Scene> {};

TEST_P(Kneip5ptLaws, FindsTheRotationOfExactData) {
  Random random(1);
  int failures = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto p = make_problem(GetParam(), 5, random);
    failures += !(error(relrot_5pt_kneip(five(p.x1), five(p.x2)), p.cam2_from_cam1.R) < 1e-6);
  }
  EXPECT_LE(failures, GetParam() == Scene::kTinyBaseline ? 10 : 2);
}

TEST_P(Kneip5ptLaws, EverySolutionMakesTheNormalsCoplanarAndHasItsTwin) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = make_problem(GetParam(), 5, random);
    const Rotations rotations = relrot_5pt_kneip(five(p.x1), five(p.x2));
    expect_finite_rotations(rotations);
    ASSERT_EQ(rotations.size() % 2, 0u);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const auto t = translation_npt({p.x1.data(), 5}, {p.x2.data(), 5}, rotations[i]);
      ASSERT_TRUE(t);
      for (int k = 0; k < 5; ++k) EXPECT_NEAR(t->dot(p.x2[k].cross(rotations[i] * p.x1[k])), 0, 1e-11);
      const Eigen::Matrix3d twin = (2 * *t * t->transpose() - Eigen::Matrix3d::Identity()) * rotations[i];
      EXPECT_LT(rotation_error(twin, rotations[i ^ 1]), 1e-4);
    }
  }
}

TEST_P(Kneip5ptLaws, TurnsWithTheCamerasAndInvertsWhenSwapped) {
  Random random(3);
  int failures = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = make_problem(GetParam(), 5, random);
    const Eigen::Matrix3d Q1 = so3_exp(3 * random.direction()), Q2 = so3_exp(3 * random.direction());
    const Eigen::Matrix3d& R = p.cam2_from_cam1.R;
    failures += !(error(relrot_5pt_kneip(five(p.x1, Q1), five(p.x2, Q2)), Q2 * R * Q1.transpose()) < 1e-6);
    failures += !(error(relrot_5pt_kneip(five(p.x2), five(p.x1)), R.transpose()) < 1e-6);
  }
  EXPECT_LE(failures, GetParam() == Scene::kTinyBaseline ? 4 : 1);
}

TEST_P(Kneip5ptLaws, MoreBearingsPutTheTrueRotationFirst) {
  if (GetParam() == Scene::kPlanar) GTEST_SKIP() << "a plane fits two motions, whatever the number of points";
  Random random(4);
  int failures = 0;
  for (const std::size_t n : {6, 7, 8})
    for (int trial = 0; trial < 100; ++trial) {
      const auto p = make_problem(GetParam(), n, random);
      const Rotations rotations = relrot_5pt_kneip(p.x1, p.x2);
      expect_finite_rotations(rotations);
      failures +=
          rotations.size() < 2 || !(std::min(rotation_error(rotations[0], p.cam2_from_cam1.R),
                                             rotation_error(rotations[1], p.cam2_from_cam1.R)) < 1e-6);
    }
  EXPECT_LE(failures, GetParam() == Scene::kTinyBaseline ? 6 : 1);
}

// Bearings with noise fit no rotation exactly, and have an answer all the same.
TEST(Kneip5pt, MoreBearingsWithNoiseHaveAnAnswer) {
  Random random(6);
  int empty = 0;
  for (const std::size_t n : {6, 7, 8})
    for (int trial = 0; trial < 100; ++trial) {
      auto p = make_problem(Scene::kOdometry, n, random);
      for (auto* bearings : {&p.x1, &p.x2})
        for (Bearing& x : *bearings) x = (x + 0.5 / 525 * random.normal3()).normalized();
      const Rotations rotations = relrot_5pt_kneip(p.x1, p.x2);
      expect_finite_rotations(rotations);
      empty += rotations.empty();
    }
  EXPECT_LE(empty, 24);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Kneip5ptLaws,
                         ::testing::Values(Scene::kRandom, Scene::kOdometry, Scene::kPlanar, Scene::kForward,
                                           Scene::kTinyBaseline),
                         [](const auto& info) { return testing::name(info.param); });

TEST(Kneip5pt, DegenerateDataGiveFiniteRotationsOrNone) {
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const auto still = make_problem(Scene::kPureRotation, 5, random);
    expect_finite_rotations(relrot_5pt_kneip(five(still.x1), five(still.x2)));
    auto p = make_problem(Scene::kRandom, 5, random);
    expect_finite_rotations(relrot_5pt_kneip(five(p.x1), five(p.x1)));
    p.x1[1] = p.x1[0], p.x2[1] = p.x2[0];
    expect_finite_rotations(relrot_5pt_kneip(five(p.x1), five(p.x2)));
    p.x1[3] = p.x1[2], p.x2[3] = p.x2[2];
    expect_finite_rotations(relrot_5pt_kneip(five(p.x1), five(p.x2)));
    // Points of one line in space
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector3d X = p.X1[0] + 0.2 * i * (p.X1[4] - p.X1[0]);
      p.x1[i] = X.normalized(), p.x2[i] = (p.cam2_from_cam1 * X).normalized();
    }
    expect_finite_rotations(relrot_5pt_kneip(five(p.x1), five(p.x2)));
  }
  const Five same{Bearing::UnitZ(), Bearing::UnitZ(), Bearing::UnitZ(), Bearing::UnitZ(), Bearing::UnitZ()};
  expect_finite_rotations(relrot_5pt_kneip(same, same));
}

TEST(Kneip5pt, IsEmptyOnNaN) {
  Random random(6);
  auto p = make_problem(Scene::kRandom, 5, random);
  p.x1[2].setConstant(NAN);
  EXPECT_TRUE(relrot_5pt_kneip(five(p.x1), five(p.x2)).empty());
}

TEST(Kneip5pt, RefusesOtherSizes) {
  const std::vector<Bearing> x(9, Bearing::UnitZ());
  EXPECT_THROW(relrot_5pt_kneip(x, x), std::invalid_argument);
  EXPECT_THROW(relrot_5pt_kneip({x.data(), 4}, {x.data(), 4}), std::invalid_argument);
  EXPECT_THROW(relrot_5pt_kneip({x.data(), 6}, {x.data(), 5}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
