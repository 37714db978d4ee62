// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/depth_filter.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

constexpr double kTruth = 0.4, kSigma = 0.5 / 500, kMaxError = 2.0 / 500;
const Pose kStep{so3_exp({0.01, -0.03, 0.02}), {0.3, -0.05, 0.1}};

MapPoint guessed(double inverse_z, double sigma) {
  MapPoint point{};
  point.ray = {0.2, -0.1, 1};
  point.inverse_z = inverse_z, point.variance = sigma * sigma;
  return point;
}

Eigen::Vector3d sight(const MapPoint& point, const Pose& cam_from_host) {
  const Eigen::Vector3d x = cam_from_host * (point.ray / kTruth);
  return x / x.z();
}

TEST(TakeIn, ExactSightsBringAnyGuessToTheTruth) {
  for (const double guess : {0.15, 0.4, 0.9}) {
    MapPoint point = guessed(guess, 0.5);
    for (int i = 1; i <= 12; ++i) {
      const Pose pose{kStep.R, 0.5 * i * kStep.t};
      ASSERT_TRUE(take_in(point, sight(point, pose), kSigma, pose, kMaxError)) << guess << " " << i;
    }
    EXPECT_NEAR(point.inverse_z, kTruth, 1e-4);
    EXPECT_TRUE(point.is_known());
  }
}

TEST(TakeIn, WithoutABaselineNothingIsLearned) {
  MapPoint point = guessed(0.7, 0.35);
  const Pose turned{kStep.R, Eigen::Vector3d::Zero()};
  EXPECT_TRUE(take_in(point, sight(point, turned), kSigma, turned, kMaxError));
  EXPECT_EQ(point.inverse_z, 0.7);
  EXPECT_NEAR(point.variance, 0.35 * 0.35, 1e-12);
  EXPECT_FALSE(point.is_known());
}

TEST(TakeIn, WhatMissesTheEpipolarLineOrDisagreesIsRefused) {
  MapPoint point = guessed(0.4, 0.1);
  const Eigen::Vector3d seen = sight(point, kStep);
  const Eigen::Vector2d along = kStep.t.head<2>() - kStep.t.z() * seen.head<2>();
  const Eigen::Vector2d across = Eigen::Vector2d(-along.y(), along.x()).normalized();
  EXPECT_FALSE(take_in(point, {seen.x() + 0.02 * across.x(), seen.y() + 0.02 * across.y(), 1}, kSigma, kStep,
                       kMaxError));
  const Eigen::Vector2d far = seen.head<2>() + 0.3 * along.normalized();
  EXPECT_FALSE(take_in(point, {far.x(), far.y(), 1}, kSigma, kStep, kMaxError));
  EXPECT_EQ(point.inverse_z, 0.4);
  EXPECT_EQ(point.variance, 0.1 * 0.1);
}

TEST(TakeIn, APointAtInfinityStaysInFrontOfTheCamera) {
  MapPoint point = guessed(0.1, 0.2);
  const Eigen::Vector3d direction = kStep.R * point.ray;
  for (int i = 0; i < 20; ++i) take_in(point, direction / direction.z(), kSigma, kStep, kMaxError);
  EXPECT_GT(point.inverse_z, 0);
  EXPECT_LT(point.inverse_z, 0.02);
}

TEST(GuessedInverseDepth, IsThatOfTheNeighboursAndCoversInfinity) {
  std::vector<DepthAtPixel> known;
  for (int i = 0; i < 6; ++i)
    known.push_back({{10.0 + i, 20}, 0.5}), known.push_back({{200.0 + i, 20}, 0.05});
  for (const auto& [u, expected] : {std::pair{12.0, 0.5}, std::pair{201.0, 0.05}}) {
    const auto guess = guessed_inverse_depth(known, {u, 22});
    ASSERT_TRUE(guess);
    EXPECT_EQ(guess->value, expected);
    EXPECT_LE(guess->value - 2 * guess->sigma, 0);
  }
  EXPECT_FALSE(guessed_inverse_depth({}, {1, 1}));
}

// A camera that moves to the side with poses that are known: what it traces has the depth of the image.
TEST(TracePoints, TellDepthsAsWellAsTheySay) {
  const Boxes boxes;
  const Camera camera = Boxes::camera();
  const auto pose_of = [](int i) { return Pose{so3_exp({0, -0.01 * i, 0}), {0.04 * i, 0, 0.01 * i}}; };
  const Frame first = boxes.frame(pose_of(0), 0);
  auto described = std::make_shared<MapFrame>(look_at(first, 0));
  describe(*described, camera, {});
  LocalMap map(4);
  Keyframe& host = map.add(described, pose_of(0));
  const int added = add_guessed_points(host, {}, {{{160, 120}, 0.4}}, camera);
  ASSERT_GT(added, 100);
  for (int i = 1; i <= 5; ++i)
    trace_points(map, {0}, {}, look_at(boxes.frame(pose_of(i), i), i), pose_of(i), {}, camera);
  int known = 0, wrong = 0;
  for (const MapPoint& point : host.points) {
    if (point.is_given_up || !point.is_known()) continue;
    const Eigen::Vector2d p = host.frame->pixel(point.feature);
    const double z = first.depth.at<float>(static_cast<int>(p.y() + 0.5), static_cast<int>(p.x() + 0.5));
    ++known, wrong += !(std::abs(point.inverse_z - 1 / z) < 3 * std::sqrt(point.variance));
  }
  EXPECT_GT(known, added / 2);
  EXPECT_LT(wrong, known / 20);
}

}  // namespace
}  // namespace framewise
