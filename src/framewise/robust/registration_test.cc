// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/registration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::Scene;
using testing::TwoViewProblem;

// The first `wrong` points of the second cloud are moved by up to 2 m.
TwoViewProblem with_outliers(std::size_t size, std::size_t wrong, double noise, Random& random) {
  TwoViewProblem p = make_problem(Scene::kRandom, size, random);
  for (auto& X : p.X2) X += noise * random.normal3();
  for (std::size_t i = 0; i < wrong; ++i) p.X2[i] += (0.5 + random.uniform(0, 1.5)) * random.direction();
  return p;
}

TEST(Registration, FindsTheMotionAmongThreeQuartersOfOutliers) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto p = with_outliers(200, 150, 0.005, random);
    const auto estimate = estimate_registration(p.X1, p.X2);
    ASSERT_TRUE(estimate);
    EXPECT_LT(testing::rotation_error(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R), 0.003);
    EXPECT_LT((estimate->cam2_from_cam1.t - p.cam2_from_cam1.t).norm(), 0.01);
    EXPECT_GE(estimate->num_inliers, 50u);
    EXPECT_LE(estimate->num_inliers, 52u);
  }
}

TEST(Registration, IsExactWithoutNoise) {
  Random random(2);
  const auto p = with_outliers(50, 20, 0, random);
  const auto estimate = estimate_registration(p.X1, p.X2);
  ASSERT_TRUE(estimate);
  EXPECT_LT((estimate->cam2_from_cam1.matrix() - p.cam2_from_cam1.matrix()).norm(), 1e-12);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(estimate->inliers[i], i >= 20) << i;
}

TEST(Registration, SameSeedGivesTheSameBits) {
  Random random(3);
  const auto p = with_outliers(100, 50, 0.01, random);
  const auto a = estimate_registration(p.X1, p.X2), b = estimate_registration(p.X1, p.X2);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->cam2_from_cam1.matrix(), b->cam2_from_cam1.matrix());
  EXPECT_EQ(a->iterations, b->iterations);
}

TEST(Registration, HasNoAnswerFromTooLittle) {
  Random random(4);
  const auto p = with_outliers(60, 60, 0, random);
  RegistrationOptions options;
  options.min_inliers = 10;
  options.ransac.max_iterations = 200;
  EXPECT_FALSE(estimate_registration(p.X1, p.X2, options));
  EXPECT_FALSE(estimate_registration(std::span(p.X1).first(2), std::span(p.X2).first(2)));
  EXPECT_FALSE(estimate_registration({}, {}));
}

TEST(Registration, NamesTheArgumentThatIsWrong) {
  Random random(5);
  auto p = with_outliers(10, 0, 0, random);
  const auto message = [&](const RegistrationOptions& options = {}) -> std::string {
    try {
      estimate_registration(p.X1, p.X2, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  RegistrationOptions options;
  options.max_error = 0;
  EXPECT_THAT(message(options), ::testing::HasSubstr("max_error"));
  options = {};
  options.ransac.confidence = 1;
  EXPECT_THAT(message(options), ::testing::HasSubstr("confidence"));
  p.X2[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message(), ::testing::HasSubstr("X2[3]"));
  p.X2.pop_back();
  EXPECT_THAT(message(), ::testing::HasSubstr("9 elements"));
}

}  // namespace
}  // namespace framewise
