// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/points_with_depth.h"

#include <gtest/gtest.h>

#include <limits>

#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

MapPoint known(double inverse_z, double sigma) {
  MapPoint point{};
  point.ray = {0.2, -0.1, 1};
  point.inverse_z = point.measured = inverse_z;
  point.variance = sigma * sigma, point.information = 1 / point.variance;
  return point;
}

TEST(TakeInDepth, TwoLooksOfOneSigmaMeetInTheMiddle) {
  MapPoint point = known(0.5, 0.01);
  take_in_depth(point, 0.51, 0.01);
  EXPECT_NEAR(point.inverse_z, 0.505, 1e-12);
  EXPECT_NEAR(point.measured, 0.505, 1e-12);
  EXPECT_NEAR(point.variance, 0.01 * 0.01 / 2, 1e-12);
}

TEST(TakeInDepth, WhatIsOfAnotherSurfaceIsLeftOut) {
  MapPoint point = known(0.5, 0.01);
  take_in_depth(point, 0.55, 0.01);
  EXPECT_EQ(point.inverse_z, 0.5);
}

TEST(TakeInDepth, LooksWithoutEndTellNoMoreThanTen) {
  MapPoint point = known(0.5, 0.01);
  for (int i = 0; i < 1000; ++i) take_in_depth(point, 0.5, 0.01);
  EXPECT_NEAR(point.variance, 0.01 * 0.01 / 10, 1e-7);
}

class KeyframeOfBoxes : public testing::Test {
 protected:
  KeyframeOfBoxes() : map(3) {
    auto frame = std::make_shared<MapFrame>(look_at(boxes.frame({}, 0), 0));
    describe(*frame, Boxes::camera(), {});
    map.add(frame, {});
  }
  Keyframe& keyframe() { return map.at(0); }
  const Boxes boxes;
  const OdometryOptions options;
  LocalMap map;
};

TEST_F(KeyframeOfBoxes, ItsPointsHaveTheDepthOfTheImage) {
  add_points_with_depth(keyframe(), {}, {}, Boxes::camera(), options);
  EXPECT_GT(keyframe().points.size(), 100u);
  for (const MapPoint& point : keyframe().points) {
    const Eigen::Vector2d p = keyframe().frame->pixel(point.feature);
    const cv::Mat& depth = keyframe().frame->depth;
    EXPECT_NEAR(point.inverse_z * depth.at<float>(std::lround(p.y()), std::lround(p.x())), 1, 0.02);
    EXPECT_TRUE(point.is_known());
  }
}

TEST_F(KeyframeOfBoxes, PointsKeepTheirDistanceFromThoseThatAreSeen) {
  const TrackedPoint seen{{1, 0}, {160, 120}, {0, 0, 1}, 0.1};
  add_points_with_depth(keyframe(), {seen}, {}, Boxes::camera(), options);
  ASSERT_FALSE(keyframe().points.empty());
  for (const MapPoint& point : keyframe().points)
    EXPECT_GT((keyframe().frame->pixel(point.feature) - seen.pixel).cwiseAbs().maxCoeff(), 5.9);
}

TEST_F(KeyframeOfBoxes, WithoutDepthThereAreNone) {
  MapFrame blind = *keyframe().frame;
  blind.depth = std::numeric_limits<float>::quiet_NaN();
  keyframe().frame = std::make_shared<MapFrame>(blind);
  add_points_with_depth(keyframe(), {}, {}, Boxes::camera(), options);
  EXPECT_TRUE(keyframe().points.empty());
}

// A point that is told a tenth of a sigma off, and what one frame's depth makes of it.
TEST_F(KeyframeOfBoxes, ALaterFramesDepthIsTakenByPointsThatAgree) {
  keyframe().points = {known(0.5, 0.05), known(0.5, 0.05)};
  Placed placed;
  placed.pose.inliers = {1, 0};
  for (int i = 0; i < 2; ++i) {
    placed.points.push_back({{0, i}, {0, 0}, {0.2, -0.1, 1}, 0.1});
    MapMatch match{};
    match.X.setZero(), match.S.setZero();
    match.ray = {0.2, -0.1, 1}, match.z = 1.95;
    placed.matches.push_back(match);
  }
  take_in_depths(map, placed, {}, {});
  EXPECT_GT(keyframe().points[0].inverse_z, 0.505);
  EXPECT_LT(keyframe().points[0].variance, 0.05 * 0.05);
  EXPECT_EQ(keyframe().points[1].inverse_z, 0.5);
}

}  // namespace
}  // namespace framewise
