// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/two_view_start.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

MapFrame described(const Pose& world_from_cam) {
  static const Boxes boxes;
  MapFrame frame = look_at(boxes.frame(world_from_cam, 0), 0);
  describe(frame, Boxes::camera(), {});
  return frame;
}

TwoViewStart start(const Pose& world_from_cam2) {
  return start_from_two_views(described({}), described(world_from_cam2), Boxes::camera(), {});
}

TEST(ShowsMotion, ByHalfOfThePointsOrByEnoughOfThemWhereTheDirectionIsSure) {
  const TwoViewOptions options;
  const double deg = M_PI / 180, sure = 0.1 * deg, unsure = 1 * deg;
  const auto angles = [&](int near, int far) {
    std::vector<double> all(near, 2 * options.min_parallax_deg * deg);
    all.resize(near + far, 0.1 * options.min_parallax_deg * deg);
    return all;
  };
  EXPECT_TRUE(shows_motion(angles(60, 50), unsure * unsure, options));
  EXPECT_FALSE(shows_motion(angles(50, 300), unsure * unsure, options));
  EXPECT_TRUE(shows_motion(angles(50, 300), sure * sure, options));
  EXPECT_FALSE(shows_motion(angles(options.min_points - 1, 300), sure * sure, options));
}

TEST(StartFromTwoViews, MotionToTheSideGivesItsDirectionAndPoints) {
  const Pose world_from_cam2{so3_exp({0, -0.03, 0}), {0.15, 0.02, 0.03}};
  const auto found = start(world_from_cam2);
  ASSERT_EQ(found.kind, TwoViewStart::Kind::kTriangulated);
  const Pose expected = world_from_cam2.inverse();
  EXPECT_LT(rotation_angle(found.cam2_from_cam1.R.transpose() * expected.R), 0.003);
  EXPECT_GT(found.cam2_from_cam1.t.normalized().dot(expected.t.normalized()), 0.998);
  EXPECT_EQ(found.points.size(), found.seen_by.size());
  for (const MapPoint& point : found.points) EXPECT_GT(point.inverse_z, 0);
}

TEST(StartFromTwoViews, ATurnAloneIsATurnAndInventsNoMotion) {
  const Pose turned{so3_exp({0.02, -0.08, 0.03}), {0, 0, 0}};
  const auto found = start(turned);
  EXPECT_EQ(found.kind, TwoViewStart::Kind::kTurned);
  EXPECT_TRUE(found.points.empty());
  EXPECT_LT(rotation_angle(found.cam2_from_cam1.R * turned.R), 0.002);
}

TEST(StartFromTwoViews, AStandingCameraHasNotMoved) {
  const auto found = start({});
  EXPECT_EQ(found.kind, TwoViewStart::Kind::kTurned);
  EXPECT_LT(rotation_angle(found.cam2_from_cam1.R), 1e-3);
}

TEST(StartFromTwoViews, NothingInCommonAndNothingAtAllAreUnrelated) {
  EXPECT_EQ(start({so3_exp({0, 3, 0}), {0, 0, 0}}).kind, TwoViewStart::Kind::kUnrelated);
  EXPECT_EQ(start_from_two_views({}, {}, Boxes::camera(), {}).kind, TwoViewStart::Kind::kUnrelated);
}

const OdometryOptions kOptions;

TEST(LengthByDepth, IsThatOfTheMotionWhereDepthTellsIt) {
  const Pose world_from_cam2{so3_exp({0, -0.03, 0}), {0.15, 0.02, 0.03}};
  MapFrame second = described(world_from_cam2);
  const auto found = start_from_two_views(described({}), second, Boxes::camera(), {});
  ASSERT_EQ(found.kind, TwoViewStart::Kind::kTriangulated);
  const auto length = length_by_depth(found, second, Boxes::camera(), kOptions);
  ASSERT_TRUE(length);
  EXPECT_NEAR(*length, world_from_cam2.t.norm(), 0.05 * world_from_cam2.t.norm());
  second.depth.release();
  EXPECT_FALSE(length_by_depth(found, second, Boxes::camera(), kOptions));
}

TEST(AddTwoViews, TheMapHasTheLengthThatWasAskedFor) {
  const Pose world_from_cam2{so3_exp({0, -0.03, 0}), {0.15, 0.02, 0.03}};
  const auto first = std::make_shared<MapFrame>(described({}));
  const auto second = std::make_shared<MapFrame>(described(world_from_cam2));
  const auto found = start_from_two_views(*first, *second, Boxes::camera(), {});
  ASSERT_EQ(found.kind, TwoViewStart::Kind::kTriangulated);
  const Pose world_from_cam1{so3_exp({0.3, 0, 0}), {1, 2, 3}};
  LocalMap map(3);
  map.add(first, world_from_cam1);
  const double length = world_from_cam2.t.norm();
  const SeenByBoth seen = add_two_views(map, second, found, length, Boxes::camera(), {});
  EXPECT_NEAR((map.newest().world_from_cam.t - world_from_cam1.t).norm(), length, 1e-9);
  ASSERT_EQ(map.at(0).points.size(), found.points.size());
  ASSERT_EQ(seen.by_second.size(), found.points.size());
  const Pose cam2_from_cam1 = map.newest().world_from_cam.inverse() * world_from_cam1;
  for (std::size_t i = 0; i < seen.by_second.size(); ++i) {
    const auto pixel = Boxes::camera().project(cam2_from_cam1 * map.point(seen.by_second[i].ref).position());
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - seen.by_second[i].pixel).norm(), 2);
    EXPECT_EQ(map.at(0).points[i].views.size(), 1u);
  }
}

}  // namespace
}  // namespace framewise
