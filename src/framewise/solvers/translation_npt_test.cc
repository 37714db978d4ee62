// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/translation_npt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::make_problem;
using testing::Random;
using testing::Scene;

class TranslationNptLaws : public ::testing::TestWithParam<Scene> {};

TEST_P(TranslationNptLaws, ExactOnExactData) {
  Random random(1);
  for (const std::size_t n : {3, 10, 100})
    for (int trial = 0; trial < 100; ++trial) {
      const auto p = make_problem(GetParam(), n, random);
      const auto t = translation_npt(p.x1, p.x2, p.cam2_from_cam1.R);
      ASSERT_TRUE(t);
      EXPECT_LT(direction_error(*t, p.cam2_from_cam1.t), 1e-7);
      const auto back = translation_npt(p.x2, p.x1, p.cam2_from_cam1.R.transpose());
      ASSERT_TRUE(back);
      EXPECT_LT(direction_error(*back, p.cam2_from_cam1.inverse().t), 1e-7);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, TranslationNptLaws,
                         ::testing::Values(Scene::kRandom, Scene::kOdometry, Scene::kPlanar, Scene::kForward,
                                           Scene::kTinyBaseline),
                         [](const auto& info) { return testing::name(info.param); });

Bearing disturbed(const Bearing& x, double sigma, Random& random) {
  return (x + sigma * random.normal3()).normalized();
}

TEST(TranslationNpt, NoDirectionNearbyFitsNoisyDataBetter) {
  Random random(2);
  auto p = make_problem(Scene::kRandom, 20, random);
  std::vector<double> weights;
  for (Bearing& x : p.x2) x = disturbed(x, 1e-3, random), weights.push_back(random.uniform(0.1, 2));
  const auto cost = [&](const Eigen::Vector3d& t) {
    double sum = 0;
    for (std::size_t i = 0; i < p.x1.size(); ++i) {
      const double residual = t.dot((p.cam2_from_cam1.R * p.x1[i]).cross(p.x2[i]));
      sum += weights[i] * residual * residual;
    }
    return sum;
  };
  const auto t = translation_npt(p.x1, p.x2, p.cam2_from_cam1.R, weights);
  ASSERT_TRUE(t);
  EXPECT_LT(direction_error(*t, p.cam2_from_cam1.t), 0.02);
  for (int trial = 0; trial < 50; ++trial)
    EXPECT_LT(cost(*t), cost((*t + 1e-3 * random.direction()).normalized()));
}

TEST(TranslationNpt, ZeroWeightRemovesAPoint) {
  Random random(3);
  auto p = make_problem(Scene::kRandom, 10, random);
  p.x2[4] = random.direction();
  std::vector<double> weights(10, 1.0);
  weights[4] = 0;
  const auto t = translation_npt(p.x1, p.x2, p.cam2_from_cam1.R, weights);
  ASSERT_TRUE(t);
  EXPECT_LT(direction_error(*t, p.cam2_from_cam1.t), 1e-9);
}

TEST(TranslationNpt, IsEmptyWhereTheDataDoNotSuffice) {
  Random random(4);
  const auto still = make_problem(Scene::kPureRotation, 20, random);
  EXPECT_FALSE(translation_npt(still.x1, still.x2, still.cam2_from_cam1.R));
  auto p = make_problem(Scene::kRandom, 5, random);
  EXPECT_FALSE(translation_npt({}, {}, p.cam2_from_cam1.R));
  EXPECT_FALSE(translation_npt({p.x1.data(), 1}, {p.x2.data(), 1}, p.cam2_from_cam1.R));
  const std::vector<Bearing> same1(5, p.x1[0]), same2(5, p.x2[0]);
  EXPECT_FALSE(translation_npt(same1, same2, p.cam2_from_cam1.R));
  p.x2[3].setConstant(NAN);
  EXPECT_FALSE(translation_npt(p.x1, p.x2, p.cam2_from_cam1.R));
}

TEST(TranslationNpt, RefusesSizesThatDiffer) {
  const std::vector<Bearing> x(5, Bearing::UnitZ());
  const std::vector<double> weights(4, 1.0);
  EXPECT_THROW(translation_npt(x, {x.data(), 4}, Eigen::Matrix3d::Identity()), std::invalid_argument);
  EXPECT_THROW(translation_npt(x, x, Eigen::Matrix3d::Identity(), weights), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
