// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/relative_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <thread>

#include "framewise/robust/robust_problems_for_tests.h"
#include "framewise/robust/translation.h"
#include "framewise/robust/two_stage.h"

namespace framewise {
namespace {

using testing::kPixel;
using testing::make_noisy_problem;
using testing::motion_error_deg;
using testing::Random;
using testing::rotation_error;
using testing::Scene;
using testing::TwoViewProblem;

constexpr RelativePoseSolver kSolvers[] = {
    RelativePoseSolver::kEightPoint,       RelativePoseSolver::kSevenPoint,
    RelativePoseSolver::kNister5pt,        RelativePoseSolver::kStewenius5pt,
    RelativePoseSolver::kKneip5ptRotation, RelativePoseSolver::kEigensolver};

TEST(RelativePose, EverySolverFindsTheMotionAmongOutliers) {
  for (const RelativePoseSolver solver : kSolvers) {
    Random random(1);
    int found = 0;
    constexpr int kTrials = 6;
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto p = make_noisy_problem(Scene::kForward, 200, 40, 0.5 * kPixel, random);
      RelativePoseOptions options;
      options.solver = solver;
      options.ransac.min_iterations = 50;
      options.ransac.max_iterations = 300;
      const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
      ASSERT_TRUE(estimate);
      EXPECT_NEAR(estimate->cam2_from_cam1.t.norm(), 1, 1e-12);
      found +=
          motion_error_deg(estimate->cam2_from_cam1, p.cam2_from_cam1) < 2 && estimate->num_inliers > 150;
    }
    EXPECT_GE(found, kTrials - 1) << static_cast<int>(solver);
  }
}

TEST(RelativePose, EveryMeasureFindsTheMotionAmongOutliers) {
  for (const InlierMeasure measure :
       {InlierMeasure::kSampson, InlierMeasure::kReprojection, InlierMeasure::kBearingEuclidean}) {
    Random random(2);
    for (int trial = 0; trial < 5; ++trial) {
      const auto p = make_noisy_problem(Scene::kOdometry, 200, 40, 0.5 * kPixel, random);
      RelativePoseOptions options;
      options.solver = RelativePoseSolver::kEightPoint;
      options.measure = measure;
      // The whole motion of a point lies within the third measure.
      if (measure == InlierMeasure::kBearingEuclidean) options.max_error = 40 * kPixel;
      const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
      ASSERT_TRUE(estimate);
      EXPECT_LT(rotation_error(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R), 0.02)
          << static_cast<int>(measure);
      EXPECT_GT(estimate->num_inliers, 120u);
      EXPECT_LT(estimate->num_inliers, 185u);
    }
  }
}

TEST(RelativePose, IsExactWithoutNoise) {
  Random random(3);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry, Scene::kForward}) {
    const auto p = make_noisy_problem(scene, 100, 20, 0, random);
    RelativePoseOptions options;
    options.solver = RelativePoseSolver::kEightPoint;
    options.max_error = 0.1 * kPixel;
    const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
    ASSERT_TRUE(estimate) << name(scene);
    EXPECT_EQ(estimate->kind, EstimateKind::kFull) << name(scene);
    EXPECT_LT(motion_error_deg(estimate->cam2_from_cam1, p.cam2_from_cam1), 1e-4) << name(scene);
  }
}

TEST(RelativePose, SeesBehindThePinhole) {
  Random random(4);
  TwoViewProblem p = make_noisy_problem(Scene::kRandom, 100, 0, 0.1 * kPixel, random);
  // Both cameras turned so that many bearings have z < 0; x2 = R x1 + t becomes Q x2 = Q R Q' Q x1 + Q t.
  const Eigen::Matrix3d Q = so3_exp(Eigen::Vector3d(0, 1.5, 0));
  for (auto* bearings : {&p.x1, &p.x2}) {
    for (auto& x : *bearings) x = Q * x;
  }
  p.cam2_from_cam1 = {Q * p.cam2_from_cam1.R * Q.transpose(), Q * p.cam2_from_cam1.t};
  RelativePoseOptions options;
  options.solver = RelativePoseSolver::kEightPoint;
  const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
  ASSERT_TRUE(estimate);
  EXPECT_LT(motion_error_deg(estimate->cam2_from_cam1, p.cam2_from_cam1), 1);
}

TEST(RelativePose, SameSeedGivesTheSameBitsInEveryThread) {
  Random random(5);
  const auto p = make_noisy_problem(Scene::kOdometry, 200, 60, 0.5 * kPixel, random);
  std::optional<Estimate> a, b;
  std::thread first([&] { a = estimate_relative_pose(p.x1, p.x2); });
  std::thread second([&] { b = estimate_relative_pose(p.x1, p.x2); });
  first.join();
  second.join();
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->cam2_from_cam1.matrix(), b->cam2_from_cam1.matrix());
  EXPECT_EQ(a->iterations, b->iterations);
  EXPECT_EQ(a->inliers, b->inliers);
}

TEST(RelativePose, PureRotationIsReportedAndItsRotationRight) {
  Random random(6);
  for (const Scene scene : {Scene::kPureRotation, Scene::kTinyBaseline}) {
    for (int trial = 0; trial < 10; ++trial) {
      const auto p = make_noisy_problem(scene, 300, 60, 0.5 * kPixel, random);
      RelativePoseOptions options;
      options.solver = RelativePoseSolver::kEightPoint;
      const auto estimate = estimate_relative_pose(p.x1, p.x2, options);
      ASSERT_TRUE(estimate);
      EXPECT_EQ(estimate->kind, EstimateKind::kRotationOnly) << name(scene);
      EXPECT_EQ(estimate->cam2_from_cam1.t.norm(), 0);
      EXPECT_LT(rotation_error(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R), 1e-3) << name(scene);
      EXPECT_TRUE((estimate->covariance.topLeftCorner<3, 3>().allFinite()));
      EXPECT_TRUE(std::isnan(estimate->covariance(5, 5)));
    }
  }
}

TEST(RelativePose, AWrongDirectionIsNeverConfident) {
  Random random(7);
  int full = 0;
  for (const Scene scene : {Scene::kOdometry, Scene::kPlanar, Scene::kTinyBaseline, Scene::kForward}) {
    for (int trial = 0; trial < 20; ++trial) {
      const auto p = make_noisy_problem(scene, 300, 60, kPixel, random);
      const auto estimate = estimate_relative_pose(p.x1, p.x2);
      ASSERT_TRUE(estimate);
      if (estimate->kind != EstimateKind::kFull) continue;
      ++full;
      EXPECT_LT(motion_error_deg(estimate->cam2_from_cam1, p.cam2_from_cam1), 30) << name(scene);
    }
  }
  EXPECT_GT(full, 40);  // and caution has its limits
}

TEST(RelativePose, HasNoAnswerFromTooFewPoints) {
  Random random(8);
  const auto p = make_noisy_problem(Scene::kRandom, 4, 0, 0, random);
  EXPECT_FALSE(estimate_relative_pose(p.x1, p.x2));
  EXPECT_FALSE(estimate_relative_pose({}, {}));
  const auto wrong = make_noisy_problem(Scene::kRandom, 60, 60, 0, random);
  RelativePoseOptions options;
  options.solver = RelativePoseSolver::kEightPoint;
  options.min_inliers = 40;
  EXPECT_FALSE(estimate_relative_pose(wrong.x1, wrong.x2, options));
}

TEST(RelativePose, NamesTheArgumentThatIsWrong) {
  Random random(9);
  auto p = make_noisy_problem(Scene::kRandom, 20, 0, 0, random);
  const auto message = [&](const RelativePoseOptions& options = {}) -> std::string {
    try {
      estimate_relative_pose(p.x1, p.x2, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  RelativePoseOptions two_point;
  two_point.solver = RelativePoseSolver::kTwoPoint;
  EXPECT_THAT(message(two_point), ::testing::HasSubstr("rotation is missing"));
  p.x1[2].setZero();
  EXPECT_THAT(message(), ::testing::HasSubstr("x1[2] has length zero"));
  p.x1[2].x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(message(), ::testing::HasSubstr("x1[2]"));
  p.x2.pop_back();
  EXPECT_THAT(message(), ::testing::HasSubstr("19 elements"));
}

TEST(Translation, IsFoundAmongOutliersWhereTheRotationIsKnown) {
  Random random(10);
  for (int trial = 0; trial < 10; ++trial) {
    const auto p = make_noisy_problem(Scene::kRandom, 200, 140, 0.5 * kPixel, random);
    const auto estimate = estimate_translation(p.x1, p.x2, p.cam2_from_cam1.R);
    ASSERT_TRUE(estimate);
    EXPECT_EQ(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R);
    EXPECT_LT(testing::direction_error(estimate->cam2_from_cam1.t, p.cam2_from_cam1.t), 0.01);
    EXPECT_EQ(estimate->kind, EstimateKind::kFull);
    EXPECT_GT(estimate->num_inliers, 55u);
  }
  const auto still = make_noisy_problem(Scene::kTinyBaseline, 100, 0, kPixel, random);
  const auto estimate = estimate_translation(still.x1, still.x2, still.cam2_from_cam1.R);
  EXPECT_TRUE(!estimate || estimate->kind == EstimateKind::kRotationOnly);
}

TEST(TwoStage, EverySolverGivesAMotionAndKeepsOnlyCloseInliers) {
  for (const RelativePoseSolver solver : kSolvers) {
    Random random(11);
    const auto p = make_noisy_problem(Scene::kRandom, 150, 30, 0.3 * kPixel, random);
    TwoStageOptions options;
    options.first.solver = solver;
    options.first.measure = InlierMeasure::kReprojection;
    options.first.ransac.min_iterations = 50;
    options.first.ransac.max_iterations = 300;
    const auto estimate = estimate_relative_pose_two_stage(p.x1, p.x2, options);
    ASSERT_TRUE(estimate) << static_cast<int>(solver);
    EXPECT_LT(rotation_error(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R), 0.05)
        << static_cast<int>(solver);
    EXPECT_GT(estimate->num_inliers, 30u);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < 30; ++i) wrong += estimate->inliers[i];
    EXPECT_LT(wrong, 5u);
  }
}

TEST(TwoStage, TooFewInliersAreNoAnswer) {
  Random random(12);
  const auto p = make_noisy_problem(Scene::kRandom, 60, 50, 0, random);
  TwoStageOptions options;
  options.first.solver = RelativePoseSolver::kEightPoint;
  options.first.min_inliers = 30;
  EXPECT_FALSE(estimate_relative_pose_two_stage(p.x1, p.x2, options));
}

}  // namespace
}  // namespace framewise
