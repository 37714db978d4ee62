// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/relative_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::direction_error;
using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;
using testing::TwoViewProblem;

// Bearings with `noise` (rad); the first `wrong` of the second view point anywhere in the image.
TwoViewProblem with_outliers(Scene scene, std::size_t size, std::size_t wrong, double noise, Random& random) {
  TwoViewProblem p = make_problem(scene, size, random);
  for (std::size_t i = 0; i < wrong; ++i) {
    p.x2[i] = Bearing(random.uniform(-0.61, 0.61), random.uniform(-0.457, 0.457), 1);
  }
  for (auto* bearings : {&p.x1, &p.x2}) {
    for (auto& x : *bearings) x = (x + noise * random.normal3()).normalized();
  }
  return p;
}

TEST(RelativePose, EightPointFindsTheMotionAmongOutliers) {
  Random random(1);
  int found = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const auto p = with_outliers(Scene::kRandom, 300, 75, 0.5 / 525, random);
    RelativePoseOptions options;
    options.solver = RelativePoseSolver::kEightPoint;
    options.ransac.min_iterations = 300;
    const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
    ASSERT_TRUE(estimate);
    EXPECT_NEAR(estimate->cam2_from_cam1.t.norm(), 1, 1e-12);
    found += rotation_error(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R) < 0.02 &&
             direction_error(estimate->cam2_from_cam1.t, p.cam2_from_cam1.t) < 0.05 &&
             estimate->num_inliers > 210;
  }
  EXPECT_GE(found, 7);  // the linear solution is poor where the views hardly overlap
}

TEST(RelativePose, HasNoAnswerFromTooFewPoints) {
  Random random(2);
  const auto p = with_outliers(Scene::kRandom, 7, 0, 0, random);
  EXPECT_FALSE(estimate_relative_pose(p.x1, p.x2));
  EXPECT_FALSE(estimate_relative_pose({}, {}));
}

TEST(RelativePose, NamesTheArgumentThatIsWrong) {
  Random random(3);
  auto p = with_outliers(Scene::kRandom, 20, 0, 0, random);
  const auto message = [&]() -> std::string {
    try {
      estimate_relative_pose(p.x1, p.x2);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  p.x1[2].setZero();
  EXPECT_THAT(message(), ::testing::HasSubstr("x1[2] has length zero"));
  p.x1[2].x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(message(), ::testing::HasSubstr("x1[2]"));
  p.x2.pop_back();
  EXPECT_THAT(message(), ::testing::HasSubstr("19 elements"));
}

}  // namespace
}  // namespace framewise
