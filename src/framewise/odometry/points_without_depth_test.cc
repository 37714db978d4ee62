// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/points_without_depth.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

Pose pose(int i) { return {so3_exp({0, -0.01 * i, 0}), {0.04 * i, 0, 0.01 * i}}; }

// A keyframe without depth.
class WithoutDepth : public testing::Test {
 protected:
  WithoutDepth() : map(4) {
    map.add(frame(0), pose(0));
    depth = boxes.frame(pose(0), 0).depth;
  }
  std::shared_ptr<MapFrame> frame(int i) const {
    Frame seen = boxes.frame(pose(i), i);
    seen.depth.release();
    auto made = std::make_shared<MapFrame>(look_at(seen, i));
    describe(*made, Boxes::camera(), {});
    return made;
  }
  // One point, of a depth that is well known, and where the keyframe has it.
  TrackedPoint known_point(double inverse_z) {
    const Eigen::Vector3d ray = map.at(0).frame->rays[0];
    map.at(0).points.push_back({0, ray, inverse_z, std::pow(0.01 * inverse_z, 2), 0, 0, {}, 0, 0});
    return {{0, 0}, map.at(0).frame->pixel(0), ray, 0.1};
  }
  const Boxes boxes;
  LocalMap map;
  cv::Mat depth;
};

TEST_F(WithoutDepth, GuessesAreAsFarAsWhatIsKnown) {
  const TrackedPoint seen = known_point(0.4);
  guess_points(map, 0, {seen}, Boxes::camera());
  EXPECT_GT(map.at(0).points.size(), 100u);
  for (std::size_t i = 1; i < map.at(0).points.size(); ++i) {
    EXPECT_NEAR(map.at(0).points[i].inverse_z, 0.4, 1e-12);
    EXPECT_FALSE(map.at(0).points[i].is_known());
  }
}

TEST_F(WithoutDepth, NothingIsGuessedFromNothing) {
  guess_points(map, 0, {}, Boxes::camera());
  EXPECT_TRUE(map.at(0).points.empty());
}

TEST_F(WithoutDepth, PlacedFramesTellHowFarGuessedPointsAreAsWellAsTheySay) {
  guess_points(map, 0, {known_point(0.4)}, Boxes::camera());
  for (int i = 1; i <= 5; ++i) {
    const auto found = look_for_depth(map, {}, *frame(i), pose(i), Boxes::camera());
    if (i == 1) {
      EXPECT_GT(found.size(), 80u);
    }
  }
  int known = 0, wrong = 0;
  for (const MapPoint& point : map.at(0).points) {
    if (point.is_given_up || !point.is_known()) continue;
    const Eigen::Vector2d p = map.at(0).frame->pixel(point.feature);
    const double z = depth.at<float>(std::lround(p.y()), std::lround(p.x()));
    ++known, wrong += !(std::abs(point.inverse_z - 1 / z) < 3 * std::sqrt(point.variance));
  }
  EXPECT_GT(known, 80);
  EXPECT_LT(wrong, known / 20 + 2);
}

TEST_F(WithoutDepth, PointsThatAFrameWasPlacedByAreNotSoughtAgain) {
  const TrackedPoint seen = known_point(0.4);
  map.at(0).points[0].variance = 0.04;
  Placed placed;
  placed.points = {seen};
  placed.matches.resize(1);
  placed.pose.inliers = {0};
  look_for_depth(map, placed, *frame(1), pose(1), Boxes::camera());
  EXPECT_EQ(map.at(0).points[0].sought, 0);
  look_for_depth(map, {}, *frame(1), pose(1), Boxes::camera());
  EXPECT_EQ(map.at(0).points[0].sought, 1);
}

}  // namespace
}  // namespace framewise
