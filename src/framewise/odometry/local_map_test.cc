// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/local_map.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 320, 240, 250, 250, 159.5, 119.5};

MapPoint point_at(const Eigen::Vector3d& ray, double z, double relative_sigma) {
  MapPoint point{};
  point.ray = ray, point.inverse_z = 1 / z;
  point.variance = std::pow(relative_sigma / z, 2);
  return point;
}

LocalMap map_of(const MapPoint& point) {
  LocalMap map(3);
  map.add(std::make_shared<MapFrame>(), {}).points.push_back(point);
  return map;
}

const Pose kAside{Eigen::Matrix3d::Identity(), {0.2, 0, 0}};
const Pose kTurned{so3_exp({0, 0.1, 0}), {0, 0, 0}};

TEST(LocalMap, ForgetsTheOldestButNotWhereItEnded) {
  LocalMap map(2);
  for (int i = 0; i < 4; ++i)
    map.add(std::make_shared<MapFrame>(), {Eigen::Matrix3d::Identity(), {1.0 * i, 0, 0}});
  EXPECT_EQ(map.first_id(), 2);
  EXPECT_EQ(map.newest_id(), 3);
  EXPECT_FALSE(map.holds(1));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(map.last_pose_of(i).t.x(), i);
}

TEST(LocalMap, GoesOnAsAnotherThatStandsElsewhere) {
  LocalMap map(3), other(3);
  map.add(std::make_shared<MapFrame>(), kTurned);
  for (int i = 0; i < 2; ++i)
    other.add(std::make_shared<MapFrame>(), {Eigen::Matrix3d::Identity(), {1.0 * i, 0, 0}});
  MapPoint point = point_at({0.1, 0.2, 1}, 2, 0.01);
  point.views.push_back({1, {0, 0, 1}, {1e-3}, 2, {0, 0, 1}, 0});
  other.at(0).points.push_back(point);
  map.go_on_as(other, kAside);
  EXPECT_FALSE(map.holds(0));
  EXPECT_EQ(map.last_pose_of(0).R, kTurned.R);
  ASSERT_TRUE(map.holds(1) && map.holds(2));
  EXPECT_EQ(map.at(1).id, 1);
  EXPECT_EQ(map.newest().world_from_cam.t, Eigen::Vector3d(1.2, 0, 0));
  EXPECT_EQ(map.at(1).points[0].views[0].keyframe, 2);  // still its neighbour
  map.add(std::make_shared<MapFrame>(), {});
  EXPECT_EQ(map.newest_id(), 3);
}

TEST(PointsInView, APointIsWhereItProjects) {
  const LocalMap map = map_of(point_at({0.1, 0.2, 1}, 2, 0.01));
  const auto seen = points_in_view(map, {0}, kAside, kCamera, {});
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].pixel - Eigen::Vector2d(159.5 + 250 * 0.0, 119.5 + 250 * 0.2)).norm(), 1e-9);
  EXPECT_EQ(seen[0].spread_px, 0);
}

TEST(PointsInView, WhatIsNotKnownSpreadsWithMotionButNotWithATurn) {
  const LocalMap map = map_of(point_at({0.1, 0.2, 1}, 2, 0.5));
  const auto turned = points_in_view(map, {0}, kTurned, kCamera, {});
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_NEAR(turned[0].spread_px, 0, 1e-9);
  // Half of 250 * 0.2 / 2 pixels.
  const auto aside = points_in_view(map, {0}, kAside, kCamera, {});
  ASSERT_EQ(aside.size(), 1u);
  EXPECT_NEAR(aside[0].spread_px, 12.5, 1e-9);
  EXPECT_TRUE(settled(aside, 12).empty());
  EXPECT_EQ(settled(aside, 13).size(), 1u);
}

TEST(PointsInView, WhatIsGivenUpOrBehindIsNotSeen) {
  MapPoint point = point_at({0.1, 0.2, 1}, 2, 0.01);
  EXPECT_TRUE(points_in_view(map_of(point), {0}, {so3_exp({0, 3, 0}), {0, 0, 0}}, kCamera, {}).empty());
  point.is_given_up = true;
  EXPECT_TRUE(points_in_view(map_of(point), {0}, {}, kCamera, {}).empty());
}

// The rays of a corrected camera are those that it has for the same pixels.
TEST(LocalMap, ACorrectedCameraSeesTheSamePixels) {
  Camera bent = kCamera;
  bent.distortion[0] = 0.05;
  auto frame = std::make_shared<MapFrame>();
  frame->features.keypoints.emplace_back(300.0f, 30.0f, 31.0f);
  frame->rays.push_back(*plane_ray(kCamera, {300, 30}));
  LocalMap map(3);
  MapPoint point = point_at(frame->rays[0], 2, 0.01);
  const Eigen::Vector3d seen = *plane_ray(kCamera, {20, 200});
  point.views.push_back({1, seen, {1e-3}, std::numeric_limits<double>::quiet_NaN(), seen, 0.3});
  map.add(frame, {}).points.push_back(point);
  map.add(frame, kAside);
  map.set_camera(kCamera, bent);
  const MapPoint& moved = map.at(0).points[0];
  EXPECT_LT((*bent.project(moved.ray) - Eigen::Vector2d(300, 30)).norm(), 1e-6);
  EXPECT_LT((*bent.project(moved.views[0].ray) - Eigen::Vector2d(20, 200)).norm(), 1e-6);
}

}  // namespace
}  // namespace framewise
