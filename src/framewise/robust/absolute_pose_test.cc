// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/absolute_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "framewise/robust/rgbd_pose.h"
#include "framewise/robust/robust_problems_for_tests.h"

namespace framewise {
namespace {

using testing::kPixel;
using testing::make_noisy_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;
using testing::TwoViewProblem;

struct Rgbd {
  TwoViewProblem problem;
  std::vector<double> z1, z2;
};

Rgbd make_rgbd(std::size_t size, std::size_t wrong, double noise, bool exact_depth, Random& random) {
  Rgbd r{make_noisy_problem(Scene::kOdometry, size, wrong, noise, random), {}, {}};
  const DepthNoise depth;
  for (std::size_t i = 0; i < size; ++i) {
    const double z1 = r.problem.X1[i].z(), z2 = r.problem.X2[i].z();
    r.z1.push_back(z1 + (exact_depth ? 0 : depth.sigma(z1) * random.normal()));
    r.z2.push_back(z2 + (exact_depth ? 0 : depth.sigma(z2) * random.normal()));
  }
  return r;
}

TEST(AbsolutePose, FindsThePoseAmongThreeQuartersOfOutliers) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const auto p = make_noisy_problem(Scene::kRandom, 200, 150, 0, random);
    const auto estimate = estimate_absolute_pose(p.X1, p.x2);
    ASSERT_TRUE(estimate);
    EXPECT_LT(rotation_error(estimate->cam2_from_cam1.R, p.cam2_from_cam1.R), 1e-6);
    EXPECT_LT((estimate->cam2_from_cam1.t - p.cam2_from_cam1.t).norm(), 1e-5);
    for (std::size_t i = 150; i < 200; ++i) EXPECT_TRUE(estimate->inliers[i]);
  }
}

TEST(AbsolutePose, HasTheErrorThatItsCovarianceSays) {
  Random random(2);
  double nees = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    auto p = make_noisy_problem(Scene::kRandom, 150, 0, 0, random);
    for (auto& x : p.x2) {
      x /= x.z();
      x += kPixel * Eigen::Vector3d(random.normal(), random.normal(), 0);
    }
    AbsolutePoseOptions options;
    options.max_error = 4 * kPixel;
    const auto estimate = estimate_absolute_pose(p.X1, p.x2, options);
    ASSERT_TRUE(estimate);
    Vector6d error;
    error << so3_log(p.cam2_from_cam1.R.transpose() * estimate->cam2_from_cam1.R),
        estimate->cam2_from_cam1.t - p.cam2_from_cam1.t;
    nees += error.dot(estimate->covariance.ldlt().solve(error)) / 6 / kTrials;
  }
  EXPECT_GT(nees, 0.75);
  EXPECT_LT(nees, 1.35);
}

TEST(RgbdPose, IsExactWithoutNoise) {
  Random random(3);
  for (int trial = 0; trial < 10; ++trial) {
    const Rgbd r = make_rgbd(100, 50, 0, true, random);
    const auto estimate = estimate_rgbd_pose(r.problem.x1, r.z1, r.problem.x2, r.z2);
    ASSERT_TRUE(estimate);
    EXPECT_LT((estimate->cam2_from_cam1.matrix() - r.problem.cam2_from_cam1.matrix()).norm(), 1e-6);
  }
}

TEST(RgbdPose, IsBetterThanPointsAlone) {
  Random random(4);
  double with_depths = 0, without = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Rgbd r = make_rgbd(200, 50, 0.5 * kPixel, false, random);
    std::vector<Eigen::Vector3d> X1;
    for (std::size_t i = 0; i < 200; ++i) X1.push_back(point_at_depth(r.problem.x1[i], r.z1[i]));
    const auto both = estimate_rgbd_pose(r.problem.x1, r.z1, r.problem.x2, r.z2);
    const auto one = estimate_absolute_pose(X1, r.problem.x2);
    ASSERT_TRUE(both && one);
    with_depths += (both->cam2_from_cam1.t - r.problem.cam2_from_cam1.t).squaredNorm();
    without += (one->cam2_from_cam1.t - r.problem.cam2_from_cam1.t).squaredNorm();
  }
  EXPECT_LT(with_depths, without);
}

TEST(RgbdPose, UsesWhatHasNoDepth) {
  Random random(5);
  Rgbd r = make_rgbd(100, 30, 0, true, random);
  for (std::size_t i = 40; i < 60; ++i) r.z1[i] = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 50; i < 70; ++i) r.z2[i] = 0;
  const auto estimate = estimate_rgbd_pose(r.problem.x1, r.z1, r.problem.x2, r.z2);
  ASSERT_TRUE(estimate);
  EXPECT_LT((estimate->cam2_from_cam1.matrix() - r.problem.cam2_from_cam1.matrix()).norm(), 1e-6);
  for (std::size_t i = 30; i < 100; ++i) EXPECT_TRUE(estimate->inliers[i]) << i;
}

TEST(AbsolutePose, NamesWhatIsWrongAndHasNoAnswerFromTooLittle) {
  Random random(6);
  Rgbd r = make_rgbd(20, 0, 0, true, random);
  EXPECT_FALSE(estimate_absolute_pose(std::span(r.problem.X1).first(3), std::span(r.problem.x2).first(3)));
  const std::vector<double> none(20, 0.0);
  EXPECT_FALSE(estimate_rgbd_pose(r.problem.x1, none, r.problem.x2, r.z2));
  const auto message = [&]() -> std::string {
    try {
      estimate_rgbd_pose(r.problem.x1, r.z1, r.problem.x2, r.z2);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(), "");
  r.z1[4] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(message(), ::testing::HasSubstr("z1[4]"));
  r.problem.x1[3].z() = -1;
  EXPECT_THAT(message(), ::testing::HasSubstr("x1[3]"));
  r.z2.pop_back();
  EXPECT_THAT(message(), ::testing::HasSubstr("z2 has 19"));
}

}  // namespace
}  // namespace framewise
