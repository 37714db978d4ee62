// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_placement.h"

#include <gtest/gtest.h>

#include <limits>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/boxes_for_tests.h"
#include "framewise/odometry/points_with_depth.h"

namespace framewise {
namespace {

const Pose kMoved{so3_exp({0.01, -0.05, 0.02}), {0.1, 0.02, 0.03}};

// A map of one keyframe, at the world's origin.
class MapOfBoxes : public testing::Test {
 protected:
  MapOfBoxes() : map(3) {
    auto frame = std::make_shared<MapFrame>(look_at(boxes.frame({}, 0), 0));
    describe(*frame, camera, {});
    add_points_with_depth(map.add(frame, {}), {}, {}, camera, options);
  }
  MapView view(const Pose& world_from_before = {}) const {
    return {map, camera, options, turns, 0, world_from_before, 0};
  }
  std::optional<Placed> placed(const Frame& seen, const Pose& predicted, const Pose& before = {}) const {
    MapFrame frame = look_at(seen, 1);
    std::optional<Placed> unsure;
    return place(frame, predicted, view(before), unsure);
  }

  const Boxes boxes;
  const Camera camera = Boxes::camera();
  const OdometryOptions options;
  const RecentTurns turns;
  LocalMap map;
};

void expect_at(const Pose& expected, const std::optional<Placed>& placed, const Pose& before = {}) {
  ASSERT_TRUE(placed);
  const Pose found = before * placed->pose.cam_from_reference.inverse();
  EXPECT_LT((found.t - expected.t).norm(), 0.002);
  EXPECT_LT(rotation_angle(found.R.transpose() * expected.R), 0.001);
}

TEST_F(MapOfBoxes, AFrameIsPlacedWhereItIs) { expect_at(kMoved, placed(boxes.frame(kMoved, 0.1), kMoved)); }

TEST_F(MapOfBoxes, ThePoseIsInTheAxesOfTheFrameBefore) {
  const Pose before{so3_exp({0, 0.02, 0}), {0.05, 0, 0}};
  expect_at(kMoved, placed(boxes.frame(kMoved, 0.1), kMoved, before), before);
}

TEST_F(MapOfBoxes, APredictionThatIsFarOffIsMadeGoodByFeatures) {
  const Pose wrong{so3_exp({0, 0.25, 0.1}), {-0.1, 0, 0}};
  expect_at(kMoved, placed(boxes.frame(kMoved, 0.1), wrong));
}

TEST_F(MapOfBoxes, WithoutDepthAFrameIsPlacedByItsImage) {
  Frame seen = boxes.frame(kMoved, 0.1);
  seen.depth.release();
  expect_at(kMoved, placed(seen, kMoved));
}

TEST_F(MapOfBoxes, WhatShowsNothingThatIsKnownHasNoPlace) {
  Frame gray = boxes.frame(kMoved, 0.1), elsewhere = boxes.frame({so3_exp({0, 3, 0}), {5, 5, -9}}, 0.1);
  gray.gray = cv::Scalar(90);
  EXPECT_FALSE(placed(gray, kMoved));
  cv::randu(gray.gray, 0, 256);
  EXPECT_FALSE(placed(gray, kMoved));
  EXPECT_FALSE(placed(elsewhere, kMoved));
  EXPECT_FALSE(placed(Frame(), kMoved));
}

TEST_F(MapOfBoxes, APointIsSeenFromBothFramesWhereItIs) {
  const auto found = placed(boxes.frame(kMoved, 0.1), kMoved);
  ASSERT_TRUE(found);
  const Correspondences seen = seen_from_before(*found, camera);
  ASSERT_EQ(seen.pixels1.size(), found->points.size());
  int off = 0;
  for (std::size_t i = 0; i < seen.x1.size(); ++i) {
    const Eigen::Vector3d X1 = seen.x1[i] * (seen.z1[i] / seen.x1[i].z());
    const auto pixel2 = camera.project(kMoved.inverse() * X1);
    off += !pixel2 || (*pixel2 - seen.pixels2[i]).norm() > 1;
  }
  EXPECT_LT(off, static_cast<int>(seen.x1.size()) / 10);
}

// Both see plenty, and none of it has depth.
TEST_F(MapOfBoxes, WhereNothingSeenHasDepthTheRotationIsMeasuredAndThePositionForetold) {
  const auto barely_deep = [&](const Pose& pose, double time) {
    Frame frame = boxes.frame(pose, time);
    frame.depth.rowRange(4, frame.depth.rows) = std::numeric_limits<float>::quiet_NaN();
    return look_at(frame, time > 0);
  };
  const Pose turned{so3_exp({0.01, -0.08, 0.03}), {0.01, 0, 0}},
      predicted{Eigen::Matrix3d::Identity(), {0.3, 0.1, 0}};
  const MapFrame first = barely_deep({}, 0), second = barely_deep(turned, 0.1);
  FrameView earlier(first), view_of_second(second);
  const LocalMap nothing(3);
  const MapView view{nothing, camera, options, turns, 0, {}, 0};
  EXPECT_FALSE(place_by_pair(second, view_of_second, earlier, {}, predicted, view));
  const auto found = place_by_views(second, view_of_second, earlier, {}, predicted, view);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_foretold);
  const Pose world_from_cam = found->pose.cam_from_reference.inverse();
  EXPECT_LT(rotation_angle(world_from_cam.R.transpose() * turned.R), 0.01);
  EXPECT_LT((world_from_cam.t - predicted.t).norm(), 1e-12);
}

// Of `found` places, all but `wrong` agree.
Placed of_quality(int sought, int found, int wrong) {
  Placed placed;
  placed.sought = sought;
  placed.points.resize(found);
  placed.matches.resize(found);
  placed.pose.inliers.assign(found, 1);
  placed.pose.num_inliers = found - wrong;
  placed.pose.covariance.setIdentity();
  return placed;
}

TEST(IsCredible, WhereMostOfWhatIsSoughtIsFoundAndAgrees) {
  EXPECT_TRUE(is_credible(of_quality(100, 100, 0), {}));
  EXPECT_TRUE(is_credible(of_quality(100, 50, 20), {}));
  EXPECT_FALSE(is_credible(of_quality(100, 50, 26), {}));
  EXPECT_FALSE(is_credible(of_quality(400, 60, 0), {}));
  EXPECT_FALSE(is_credible(of_quality(19, 19, 0), {}));
}

Placed of_noise(int inliers, double ray_scale) {
  Placed placed = of_quality(inliers, inliers, 0);
  placed.pose.ray_scale = ray_scale;
  return placed;
}

TEST(ExplainsBetter, WhereMorePointsAgreeOrTheSameToLessNoise) {
  EXPECT_TRUE(explains_better(of_noise(101, 1), of_noise(100, 1)));
  EXPECT_TRUE(explains_better(of_noise(100, 1), of_noise(100, 1.1)));
  EXPECT_FALSE(explains_better(of_noise(100, 1), of_noise(100, 1)));
}

TEST(ExplainsBetter, AFewPointsThatAgreeCloselyBeforeManyThatHardlyDo) {
  EXPECT_TRUE(explains_better(of_noise(60, 1), of_noise(240, 10)));
  EXPECT_FALSE(explains_better(of_noise(240, 10), of_noise(60, 1)));
  // Blur leaves both as noisy: then it is the number.
  EXPECT_TRUE(explains_better(of_noise(240, 5), of_noise(150, 5)));
}

TEST(IsCredible, NotWhereThePoseIsFreeOrAllIsNoise) {
  Placed placed = of_quality(100, 100, 0);
  placed.pose.ray_scale = 20;
  EXPECT_FALSE(is_credible(placed, {}));
  placed = of_quality(100, 100, 0);
  placed.pose.covariance(4, 4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_credible(placed, {}));
}

}  // namespace
}  // namespace framewise
