// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/plane_motion.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "framewise/geometry/so3.h"
#include "framewise/robust/robust_problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_noisy_problem;
using testing::Random;
using testing::Scene;

double worst_angle(const Eigen::Matrix3d& H, std::span<const Bearing> x1, std::span<const Bearing> x2) {
  double worst = 0;
  for (std::size_t i = 0; i < x1.size(); ++i)
    worst = std::max(worst, (H * x1[i]).normalized().cross(x2[i].normalized()).norm());
  return worst;
}

double nearest_motion_error(const Hypotheses<Pose, 2>& motions, const Pose& truth) {
  double least = 10;
  for (const Pose& motion : motions) {
    const double across = motion.t.cross(truth.t.normalized()).norm();
    least = std::min(least, std::max(rotation_angle(motion.R.transpose() * truth.R), across));
  }
  return least;
}

TEST(PlaneMotion, FourPointsOfAPlaneGiveTheHomographyOfAllItsPoints) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const auto p = make_noisy_problem(Scene::kPlanar, 20, 0, 0, random);
    const auto H =
        homography_4pt(std::span(p.x1).subspan(3).first<4>(), std::span(p.x2).subspan(3).first<4>());
    ASSERT_TRUE(H);
    EXPECT_LT(worst_angle(*H, p.x1, p.x2), 1e-7);
  }
}

TEST(PlaneMotion, FourPointsWithThreeInLineGiveNone) {
  const Bearing a(0, 0, 1), b(0.1, 0, 1), c(0.2, 0, 1), d(0, 0.3, 1);
  for (const auto& x : {std::array{a, b, c, d}, std::array{a, d, b, c}, std::array{a, a, c, d}})
    EXPECT_FALSE(homography_4pt(x, x));
}

TEST(PlaneMotion, OneOfTheTwoMotionsIsTheTrueOneUnderGrossOutliers) {
  Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const auto p = make_noisy_problem(Scene::kPlanar, 100, 35, 0, random);
    const auto H = robust_plane_homography(p.x1, p.x2);
    ASSERT_TRUE(H);
    EXPECT_LT(nearest_motion_error(motions_of_plane(*H), p.cam2_from_cam1), 1e-6);
  }
}

TEST(PlaneMotion, SwappedViewsGiveTheInverseHomography) {
  Random random(3);
  const auto p = make_noisy_problem(Scene::kPlanar, 50, 0, 0, random);
  const auto H = plane_homography(p.x1, p.x2), G = plane_homography(p.x2, p.x1);
  ASSERT_TRUE(H && G);
  const Eigen::Matrix3d product = *H * *G;
  EXPECT_LT((product / product(0, 0) - Eigen::Matrix3d::Identity()).norm(), 1e-8);
}

TEST(PlaneMotion, FewerThanFourPointsAndRepeatedPointsGiveNone) {
  const std::vector<Bearing> three(3, Bearing(0, 0, 1)), many(20, Bearing(0, 0, 1));
  EXPECT_FALSE(plane_homography(three, three));
  EXPECT_FALSE(robust_plane_homography(three, three));
  EXPECT_FALSE(robust_plane_homography(many, many));
}

TEST(PlaneMotion, ARotationStandsForNoMotionOfAPlane) {
  EXPECT_TRUE(motions_of_plane(so3_exp(Eigen::Vector3d(0.1, -0.2, 0.3))).empty());
}

}  // namespace
}  // namespace framewise
