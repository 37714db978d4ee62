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

}  // namespace
}  // namespace framewise
