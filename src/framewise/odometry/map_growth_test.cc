// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_growth.h"

#include <gtest/gtest.h>

#include <set>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/boxes_for_tests.h"
#include "framewise/odometry/map_matching.h"

namespace framewise {
namespace {

const Pose kStep{so3_exp({0.01, -0.03, 0.02}), {0.3, -0.05, 0.1}};
constexpr double kFocal = 500;

FeaturePair seen_from(const Pose& cam2_from_cam1, const Eigen::Vector3d& X1) {
  const Eigen::Vector3d X2 = cam2_from_cam1 * X1;
  return {0, 0, {0, 0}, X2 / X2.z(), 0.1};
}

TEST(TriangulatedPoint, IsExactFromExactRays) {
  const Eigen::Vector3d X1(0.4, -0.3, 2.5);
  const auto point = triangulated_point(X1 / X1.z(), seen_from(kStep, X1), kStep, kFocal, {});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->inverse_z, 1 / X1.z(), 1e-12);
}

TEST(TriangulatedPoint, IsRefusedWithoutParallaxOffTheLineAndBehind) {
  const Eigen::Vector3d X1(0.4, -0.3, 2.5), far = 1000 * X1, ray = X1 / X1.z();
  EXPECT_FALSE(triangulated_point(ray, seen_from(kStep, far), kStep, kFocal, {}));
  FeaturePair off = seen_from(kStep, X1);
  off.ray2 += Eigen::Vector3d(0.05 * kStep.t.y(), 0.05, 0);
  EXPECT_FALSE(triangulated_point(ray, off, kStep, kFocal, {}));
  EXPECT_FALSE(triangulated_point(ray, seen_from(kStep, X1), {kStep.R, -kStep.t}, kFocal, {}));
}

TEST(OpenFeatures, KeepTheirDistanceFromPlacesTaken) {
  MapFrame frame;
  frame.levels = {cv::Mat(100, 100, CV_8U, cv::Scalar(0))};
  for (const float u : {10.f, 20.f, 80.f}) {
    frame.features.keypoints.emplace_back(u, 50.f, 31.f);
    frame.rays.emplace_back(0, 0, 1);
  }
  EXPECT_EQ(open_features(frame, {{12, 50}, {-1e9, 1}}, 6), (std::vector<int>{1, 2}));
  EXPECT_EQ(open_features(frame, {}, 6).size(), 3u);
}

class GrownMap : public testing::Test {
 protected:
  GrownMap() : map(4) {
    const Boxes boxes;
    for (int i = 0; i < 2; ++i) {
      auto frame = std::make_shared<MapFrame>(look_at(boxes.frame(pose(i), i), i));
      describe(*frame, Boxes::camera(), {});
      map.add(frame, pose(i));
    }
    depth = boxes.frame(pose(0), 0).depth;
  }
  static Pose pose(int i) { return {so3_exp({0, -0.02 * i, 0}), {0.15 * i, 0, 0}}; }

  LocalMap map;
  cv::Mat depth;
};

TEST_F(GrownMap, HasTheDepthsOfTheScene) {
  const int added = grow_map(map, 0, 1, Boxes::camera());
  EXPECT_GT(added, 50);
  int wrong = 0;
  for (const MapPoint& point : map.at(0).points) {
    const Eigen::Vector2d p = map.at(0).frame->pixel(point.feature);
    const double z = depth.at<float>(static_cast<int>(p.y() + 0.5), static_cast<int>(p.x() + 0.5));
    wrong += !(std::abs(point.inverse_z * z - 1) < 0.1);
  }
  EXPECT_LT(wrong, added / 20);
}

TEST_F(GrownMap, DoesNotGrowTwiceInOnePlace) {
  const int added = grow_map(map, 0, 1, Boxes::camera());
  EXPECT_LT(grow_map(map, 0, 1, Boxes::camera()), added / 10);
}

TEST_F(GrownMap, MatchesNoFeatureToTwoPoints) {
  grow_map(map, 0, 1, Boxes::camera());
  const auto visible = points_in_view(map, {0}, pose(1), Boxes::camera(), {});
  const MapFrame& frame = *map.at(1).frame;
  for (const auto& matches : {match_in_window(map, visible, frame, 40), match_anywhere(map.at(0), frame)}) {
    EXPECT_GT(matches.size(), 20u);
    std::set<int> features, points;
    for (const FeatureOfPoint& match : matches)
      EXPECT_TRUE(features.insert(match.feature).second && points.insert(match.ref.point).second);
  }
}

}  // namespace
}  // namespace framewise
