// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/scoring.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/robust_problems_for_tests.h"

namespace framewise {
namespace {

using testing::kPixel;
using testing::make_noisy_problem;
using testing::Random;
using testing::Scene;
using testing::TwoViewProblem;

constexpr Scoring kScorings[] = {Scoring::kInlierCount, Scoring::kMsac, Scoring::kMarginalised};

Columns columns_of(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b, int width) {
  Columns columns(a.size(), static_cast<std::size_t>(2 * width), 7);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < width; ++k) columns.set(i, k, a[i][k]), columns.set(i, width + k, b[i][k]);
  }
  return columns;
}

std::vector<Eigen::Vector3d> on_plane(std::vector<Eigen::Vector3d> x) {
  for (auto& v : x) v /= v.z();
  return x;
}

// The score is the sum of prices of plain double residuals.
void expect_score(const std::function<Tally(const Judge&)>& score, std::size_t size, double max_error,
                  const std::function<double(std::size_t)>& residual) {
  for (const Scoring scoring : kScorings) {
    Judge judge;
    judge.max_error = max_error;
    judge.scoring = scoring;
    double cost = 0;
    std::size_t inliers = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double q = std::pow(residual(i) / max_error, 2);
      cost += price(q, scoring);
      inliers += q < 1;
    }
    const Tally tally = score(judge);
    EXPECT_TRUE(tally.complete);
    EXPECT_NEAR(static_cast<double>(tally.inliers), static_cast<double>(inliers), 1);
    EXPECT_NEAR(tally.cost, cost, 1.01) << static_cast<int>(scoring);
    EXPECT_GT(inliers, size / 4);
  }
}

TEST(Scoring, IsTheSumOfPricesOfEveryMeasure) {
  Random random(1);
  for (const std::size_t size : {33u, 64u, 500u}) {
    const TwoViewProblem p = make_noisy_problem(Scene::kRandom, size, size / 3, 0.7 * kPixel, random);
    const RowMajor3d R = p.cam2_from_cam1.R, E = essential_from_pose(p.cam2_from_cam1);
    const double* t = p.cam2_from_cam1.t.data();
    const Pose& pose = p.cam2_from_cam1;
    const auto x1 = on_plane(p.x1), x2 = on_plane(p.x2);
    const Columns plane = columns_of(x1, x2, 2), sphere = columns_of(p.x1, p.x2, 3);
    const Columns clouds = columns_of(p.X1, p.X2, 3), points = columns_of(p.X1, x2, 3);
    const Columns points_bearings = columns_of(p.X1, p.x2, 3);

    expect_score([&](const Judge& j) { return score_sampson_plane(plane, E.data(), j); }, size, 2 * kPixel,
                 [&](std::size_t i) { return sampson_residual(pose, x1[i], x2[i], ImageSurface::kPlane); });
    expect_score(
        [&](const Judge& j) { return score_sampson_sphere(sphere, E.data(), j); }, size, 2 * kPixel,
        [&](std::size_t i) { return sampson_residual(pose, p.x1[i], p.x2[i], ImageSurface::kSphere); });
    expect_score([&](const Judge& j) { return score_distance(clouds, R.data(), t, j); }, size, 0.05,
                 [&](std::size_t i) { return (pose * p.X1[i] - p.X2[i]).norm(); });
    expect_score([&](const Judge& j) { return score_projection_plane(points, R.data(), t, j); }, size,
                 4 * kPixel,
                 [&](std::size_t i) {
                   const Eigen::Vector3d X = pose * p.X1[i];
                   return X.z() > 0 ? (X / X.z() - x2[i]).norm() : 1e9;
                 });
    expect_score([&](const Judge& j) { return score_projection_sphere(points_bearings, R.data(), t, j); },
                 size, 4 * kPixel,
                 [&](std::size_t i) {
                   const Eigen::Vector3d X = pose * p.X1[i];
                   return X.dot(p.x2[i]) > 0 ? X.normalized().cross(p.x2[i]).norm() : 1e9;
                 });
  }
}

TEST(Scoring, GivesUpWhereTheSumPassesTheBound) {
  Random random(2);
  const TwoViewProblem p = make_noisy_problem(Scene::kRandom, 1000, 900, 0, random);
  const RowMajor3d E = essential_from_pose(p.cam2_from_cam1);
  const Columns sphere = columns_of(p.x1, p.x2, 3);
  Judge judge;
  judge.max_error = kPixel;
  const Tally full = score_sampson_sphere(sphere, E.data(), judge);
  EXPECT_TRUE(full.complete);
  judge.cost_bound = full.cost + 1;
  EXPECT_TRUE(score_sampson_sphere(sphere, E.data(), judge).complete);
  judge.cost_bound = full.cost / 2;
  EXPECT_FALSE(score_sampson_sphere(sphere, E.data(), judge).complete);
}

TEST(Scoring, GivesUpWhereAGoodHypothesisWouldHaveShownItself) {
  Random random(3);
  const TwoViewProblem p = make_noisy_problem(Scene::kRandom, 1000, 500, 0, random);
  const RowMajor3d E = essential_from_pose(p.cam2_from_cam1);
  const RowMajor3d wrong = essential_from_pose({p.cam2_from_cam1.R.transpose(), Eigen::Vector3d(1, 2, 3)});
  const Columns sphere = columns_of(p.x1, p.x2, 3);
  Judge judge;
  judge.max_error = kPixel;
  judge.good_share = 0.3;
  judge.bad_share = 0.05;
  EXPECT_TRUE(score_sampson_sphere(sphere, E.data(), judge).complete);
  EXPECT_FALSE(score_sampson_sphere(sphere, wrong.data(), judge).complete);
}

TEST(Price, OfMarginalisedScoringIsItsIntegral) {
  const double cut = 2.576, end = std::erfc(cut / std::sqrt(2.0));
  const auto weight = [&](double x) { return std::erfc(x / std::sqrt(2.0)) - end; };
  double integral = 0;
  std::vector<double> rho;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double x = cut * (i + 0.5) / kSteps;
    integral += x * weight(x);
    rho.push_back(integral);
  }
  for (int i = 0; i < kSteps; i += 97) {
    const double s = (i + 1.0) / kSteps;
    EXPECT_NEAR(price(s * s, Scoring::kMarginalised), rho[i] / integral, 2.5e-3) << s;
  }
}

}  // namespace
}  // namespace framewise
