// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/axes.h"

#include <gtest/gtest.h>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Eigen::Vector3d;

TEST(Axes, ARenderWithNegativeFyShowsTheSamePixelsInTheMirror) {
  // Handa et al.: u = 481.2 x / z + 319.5, v = -480 y / z + 239.5, in their world and camera.
  const Pose world_from_cam{so3_exp({0.2, -0.5, 0.1}), {0.3, 1.2, -2.25}};
  const Vector3d x_in_world(0.7, 1.9, 1.5);
  const Vector3d x = world_from_cam.inverse() * x_in_world;
  ASSERT_GT(x.z(), 0);
  const Eigen::Vector2d theirs(481.2 * x.x() / x.z() + 319.5, -480 * x.y() / x.z() + 239.5);

  const Camera camera{CameraModel::kPinhole, 640, 480, 481.2, 480, 319.5, 239.5, {}, {}};
  const Vector3d mirrored(x_in_world.x(), -x_in_world.y(), x_in_world.z());
  const Pose ours = mirrored_in_y(world_from_cam);
  EXPECT_LT((*camera.project(ours.inverse() * mirrored) - theirs).norm(), 1e-10);
  EXPECT_NEAR(ours.R.determinant(), 1, 1e-12);
}

TEST(Axes, BlendersCameraLooksDownWhenItIsNotTurned) {
  // A new camera of Blender at (1, 2, 3) looks down on the world, whose z points up; the image's top is +y.
  const Pose camera = from_blender_camera({Eigen::Matrix3d::Identity(), {1, 2, 3}});
  EXPECT_LT((camera * Vector3d(0, 0, 3) - Vector3d(1, 2, 0)).norm(), 1e-15);  // straight ahead
  EXPECT_LT((camera * Vector3d(1, 0, 3) - Vector3d(2, 2, 0)).norm(), 1e-15);  // to the right
  EXPECT_LT((camera * Vector3d(0, 1, 3) - Vector3d(1, 1, 0)).norm(), 1e-15);  // down in the image
}

TEST(Axes, BlendersUsualCameraLooksAlongYWhenTurnedByARightAngleAboutX) {
  const Pose camera = from_blender_camera({rotation_of_euler_xyz({M_PI / 2, 0, 0}), {0, 0, 0}});
  EXPECT_LT((camera.R.col(2) - Vector3d(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((camera.R.col(1) - Vector3d(0, 0, -1)).norm(), 1e-15);
}

TEST(Axes, EulerAnglesTurnAboutXFirst) {
  // x to -90 degrees about z first would go elsewhere: y -> (about x) z -> (about y) x -> (about z) y.
  const Eigen::Matrix3d R = rotation_of_euler_xyz({M_PI / 2, M_PI / 2, M_PI / 2});
  EXPECT_LT((R * Vector3d::UnitY() - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((R - so3_exp({0, 0, M_PI / 2}) * so3_exp({0, M_PI / 2, 0}) * so3_exp({M_PI / 2, 0, 0})).norm(),
            1e-15);
}

}  // namespace
}  // namespace framewise
