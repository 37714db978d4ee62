// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/rolling_shutter.h"

namespace framewise {
namespace {

constexpr double kSigma = 0.3 / 525;
const Pose kTruth{so3_exp({0.05, -0.08, 0.03}), {0.06, -0.04, 0.1}};

double gaussian(std::mt19937& random) {  // of twelve even numbers
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += static_cast<double>(random()) / 4294967295.0;
  return sum;
}

std::vector<MapMatch> matches_of(int count, std::uint32_t seed, double noise, bool with_depth) {
  std::mt19937 random(seed);
  std::vector<MapMatch> matches;
  for (int i = 0; i < count; ++i) {
    const double z = 1 + 2.5 * static_cast<double>(random()) / 4294967295.0;
    MapMatch match;
    match.X = z * Eigen::Vector3d(0.25 * gaussian(random), 0.2 * gaussian(random), 1);
    const Eigen::Vector3d x = kTruth * match.X;
    match.ray = x / x.z() + noise * kSigma * Eigen::Vector3d(gaussian(random), gaussian(random), 0);
    match.S = 1e-10 * Eigen::Matrix3d::Identity();
    match.noise.sigma = kSigma;
    match.z = with_depth ? x.z() + noise * DepthNoise().sigma(x.z()) * gaussian(random)
                         : std::numeric_limits<double>::quiet_NaN();
    matches.push_back(match);
  }
  return matches;
}

double angle(const Pose& pose) { return rotation_angle(pose.R.transpose() * kTruth.R); }

TEST(FirstPose, ComesFromThePriorWhereMostAgreeAndFromSamplesWhereFewDo) {
  auto matches = matches_of(120, 1, 1, false);
  const auto easy = first_pose(matches, {}, {});
  ASSERT_TRUE(easy);
  EXPECT_EQ(easy->iterations, 0);
  EXPECT_LT(angle(easy->cam_from_reference), 2e-3);
  std::mt19937 random(2);
  for (int i = 0; i < 80; ++i) matches[i].ray += 0.2 * Eigen::Vector3d(gaussian(random), gaussian(random), 0);
  const auto hard = first_pose(matches, {so3_exp({0, 0.6, 0.3}), {0.3, 0, 0}}, {});
  ASSERT_TRUE(hard);
  EXPECT_LT(angle(hard->cam_from_reference), 5e-3);
}

TEST(FirstPose, IsNoneWhereNothingAgrees) {
  auto matches = matches_of(60, 3, 1, false);
  std::mt19937 random(4);
  for (MapMatch& match : matches) match.ray = {0.4 * gaussian(random), 0.3 * gaussian(random), 1};
  EXPECT_FALSE(first_pose(matches, {}, {}));
  EXPECT_FALSE(first_pose({}, {}, {}));
}

TEST(RefineMapPose, ItsCovarianceIsThatOfItsErrors) {
  double nees = 0;
  constexpr int kRuns = 60;
  for (int run = 0; run < kRuns; ++run) {
    const MapPose pose = refine_map_pose(matches_of(150, 10 + run, 1, true), kTruth, {});
    Vector6d error;
    error << so3_log(pose.cam_from_reference.R.transpose() * kTruth.R), kTruth.t - pose.cam_from_reference.t;
    nees += error.dot(pose.covariance.inverse() * error) / 6 / kRuns;
    EXPECT_NEAR(pose.ray_scale, 1, 0.25);
    EXPECT_NEAR(pose.depth_scale, 1, 0.35);
  }
  EXPECT_GT(nees, 0.7);
  EXPECT_LT(nees, 1.4);
}

// Rays that slide along stripes, each in a direction of its own.
std::vector<MapMatch> striped_matches(std::uint32_t seed, bool with_depth) {
  auto matches = matches_of(150, seed, 1, with_depth);
  std::mt19937 random(seed + 1000);
  for (MapMatch& match : matches) {
    const Eigen::Vector2d along =
        Eigen::Rotation2Dd(M_PI * gaussian(random)).toRotationMatrix() * Eigen::Vector2d::UnitX();
    constexpr double kFarther = 30;
    match.ray.head<2>() += kFarther * kSigma * gaussian(random) * along;
    match.noise = PlaceNoise::of(
        kSigma * kSigma * (Eigen::Matrix2d::Identity() + kFarther * kFarther * along * along.transpose()));
  }
  return matches;
}

TEST(RefineMapPose, ARayOfAStripeCountsForWhatItTells) {
  for (const bool with_depth : {false, true}) {
    double nees = 0, squares = 0, round_squares = 0;
    constexpr int kRuns = 60;
    for (int run = 0; run < kRuns; ++run) {
      auto matches = striped_matches(50 + run, with_depth);
      const MapPose pose = refine_map_pose(matches, kTruth, {});
      Vector6d error;
      error << so3_log(pose.cam_from_reference.R.transpose() * kTruth.R),
          kTruth.t - pose.cam_from_reference.t;
      nees += error.dot(pose.covariance.inverse() * error) / 6 / kRuns;
      squares += error.head<3>().squaredNorm();
      for (MapMatch& match : matches) match.noise.shape.setIdentity();
      round_squares += std::pow(angle(refine_map_pose(matches, kTruth, {}).cam_from_reference), 2);
    }
    EXPECT_GT(nees, 0.7);
    EXPECT_LT(nees, 1.4);
    EXPECT_LT(squares, 0.1 * round_squares);
  }
}

TEST(RefineMapPose, ADepthThatDisagreesLeavesItsRay) {
  auto matches = matches_of(100, 5, 1, true);
  for (int i = 0; i < 25; ++i) matches[i].z *= 1.4;
  const MapPose pose = refine_map_pose(matches, kTruth, {});
  EXPECT_LT((pose.cam_from_reference.t - kTruth.t).norm(), 3e-3);
  EXPECT_GT(pose.num_inliers, 90);
}

TEST(ShiftBetween, IsHowFarAWallMovesInTheImage) {
  std::vector<MapMatch> matches = matches_of(50, 7, 0, true);
  for (MapMatch& match : matches) match.X *= 2 / match.X.z();
  EXPECT_EQ(shift_between(matches, kTruth, kTruth), 0);
  EXPECT_NEAR(shift_between(matches, {}, {Eigen::Matrix3d::Identity(), {0.03, 0.04, 0}}), 0.05 / 2, 1e-12);
  EXPECT_EQ(shift_between({}, {}, kTruth), 0);
}

TEST(RefineMapPose, ASurerDepthSaysMore) {
  auto matches = matches_of(100, 8, 1, true);
  const double before = refine_map_pose(matches, kTruth, {}).covariance(5, 5);
  for (MapMatch& match : matches) {
    const double z = (kTruth * match.X).z();
    match.z_share = 0.25, match.z = z + 0.25 * (match.z - z);
  }
  EXPECT_LT(refine_map_pose(matches, kTruth, {}).covariance(5, 5), before);
}

TEST(ReadoutCorrection, FindsTheReadoutThatRaysWereSeenWith) {
  auto matches = matches_of(200, 6, 0.2, true);
  const double truth = 0.015;
  const Shutter moving{truth, {0.3, 1.2, -0.4}};
  for (MapMatch& match : matches) {
    const double row = std::clamp(match.ray.y() * 525 / 480, -0.5, 0.5);
    match.ray = Shutter{-truth, moving.turn_rate}.at_middle(match.ray, row);  // as its row saw it
    match.by_readout = -Shutter{0, moving.turn_rate}.at_middle_by_readout(match.ray, row).head<2>();
    match.skew = match.by_readout.norm();
  }
  const MapPose pose = refine_map_pose(matches, kTruth, {});
  EXPECT_NEAR(readout_correction(matches, pose).seconds, truth, 0.003);
}

}  // namespace
}  // namespace framewise
