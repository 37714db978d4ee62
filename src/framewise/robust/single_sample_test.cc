// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/single_sample.h"

#include <gtest/gtest.h>

#include "framewise/robust/robust_problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::Scene;

constexpr RelativePoseSolver kAll[] = {
    RelativePoseSolver::kEightPoint,       RelativePoseSolver::kSevenPoint,
    RelativePoseSolver::kNister5pt,        RelativePoseSolver::kStewenius5pt,
    RelativePoseSolver::kKneip5ptRotation, RelativePoseSolver::kEigensolver,
    RelativePoseSolver::kTwoPoint};
constexpr InlierMeasure kMeasures[] = {InlierMeasure::kSampson, InlierMeasure::kReprojection};

RelativePoseOptions options_for(RelativePoseSolver solver, InlierMeasure measure, std::uint64_t seed,
                                const Eigen::Matrix3d& rotation) {
  RelativePoseOptions options;
  options.solver = solver;
  options.measure = measure;
  options.ransac.seed = seed;
  if (solver == RelativePoseSolver::kTwoPoint) options.rotation = rotation;
  return options;
}

TEST(SingleSample, EverySolverIsExactWithoutNoiseAndWithoutOutliers) {
  Random random(1);
  for (const RelativePoseSolver solver : kAll)
    for (const InlierMeasure measure : kMeasures) {
      int right = 0;
      constexpr int kTrials = 40;
      for (int trial = 0; trial < kTrials; ++trial) {
        const auto p = make_problem(Scene::kRandom, 50, random);
        const auto estimate = estimate_relative_pose_from_one_sample(
            p.x1, p.x2, options_for(solver, measure, trial, p.cam2_from_cam1.R));
        if (!estimate) continue;
        EXPECT_EQ(estimate->num_inliers, 50u);
        right += testing::motion_error_deg(estimate->cam2_from_cam1, p.cam2_from_cam1) < 1e-3;
      }
      // A sample may lie badly for its solver, once in a while.
      EXPECT_GE(right, kTrials - 2) << static_cast<int>(solver) << " " << static_cast<int>(measure);
    }
}

TEST(SingleSample, IsAsGoodAsItsSampleAndNoBetter) {
  // With half of the bearings wrong, five right ones are drawn once in 32 times.
  Random random(2);
  int right = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto p = testing::make_noisy_problem(Scene::kRandom, 100, 50, 0, random);
    const auto estimate = estimate_relative_pose_from_one_sample(
        p.x1, p.x2, options_for(RelativePoseSolver::kNister5pt, InlierMeasure::kSampson, trial, {}));
    right += estimate && testing::motion_error_deg(estimate->cam2_from_cam1, p.cam2_from_cam1) < 0.1;
  }
  EXPECT_LT(right, 20);
}

TEST(SingleSample, TheSeedDecides) {
  Random random(3);
  const auto p = testing::make_noisy_problem(Scene::kRandom, 60, 0, testing::kPixel, random);
  const auto with_seed = [&](std::uint64_t seed) {
    return estimate_relative_pose_from_one_sample(
               p.x1, p.x2, options_for(RelativePoseSolver::kEightPoint, InlierMeasure::kSampson, seed, {}))
        ->cam2_from_cam1.matrix();
  };
  EXPECT_EQ(with_seed(1), with_seed(1));
  EXPECT_NE(with_seed(1), with_seed(2));
}

TEST(SingleSample, RegistersThreePointsExactly) {
  Random random(4);
  const auto p = make_problem(Scene::kRandom, 30, random);
  const auto estimate = estimate_registration_from_one_sample(p.X1, p.X2, 7);
  ASSERT_TRUE(estimate);
  EXPECT_LT((estimate->cam2_from_cam1.matrix() - p.cam2_from_cam1.matrix()).norm(), 1e-10);
  EXPECT_EQ(estimate->num_inliers, 30u);
}

TEST(SingleSample, HasNoAnswerFromTooLittle) {
  Random random(5);
  const auto p = make_problem(Scene::kRandom, 4, random);
  EXPECT_FALSE(estimate_relative_pose_from_one_sample(p.x1, p.x2));
  EXPECT_FALSE(estimate_registration_from_one_sample(std::span(p.X1).first(2), std::span(p.X2).first(2), 0));
  EXPECT_THROW(estimate_relative_pose_from_one_sample(p.x1, std::span(p.x2).first(3)), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
