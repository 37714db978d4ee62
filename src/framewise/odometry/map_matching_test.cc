// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_matching.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 320, 240, 250, 260, 159.5, 119.5};
const Pose kCamFromHost{so3_exp({0.05, -0.2, 0.1}), {0.3, -0.1, -0.5}};

TEST(WarpOfPatch, IsHowOffsetsOnTheSurfaceLookInTheCamera) {
  for (const Eigen::Vector2d& slope : {Eigen::Vector2d(0, 0), {0.4, -0.3}, {-0.6, 0.1}}) {
    const Eigen::Vector3d ray(0.15, -0.1, 1);
    constexpr double kInverseZ = 0.5, kStep = 1e-5;
    const auto seen = [&](const Eigen::Vector2d& offset, const Pose& cam_from_host) {
      const Eigen::Vector3d moved = ray + Eigen::Vector3d(offset.x(), offset.y(), 0);
      return *kCamera.project(cam_from_host * (moved / (kInverseZ + slope.dot(offset))));
    };
    const auto warp = warp_of_patch(ray / kInverseZ, kCamFromHost, kCamera, slope);
    ASSERT_TRUE(warp);
    for (const Eigen::Vector2d& offset : {Eigen::Vector2d(kStep, 0), {0, kStep}}) {
      const Eigen::Vector2d in_host = seen(offset, Pose()) - seen(-offset, Pose());
      const Eigen::Vector2d in_cam = seen(offset, kCamFromHost) - seen(-offset, kCamFromHost);
      EXPECT_LT((*warp * in_host - in_cam).norm(), 1e-6 * in_cam.norm()) << slope.transpose();
    }
  }
}

TEST(WarpOfPatch, IsNoneBehindACamera) {
  EXPECT_FALSE(warp_of_patch({0, 0, 2}, {Eigen::Matrix3d::Identity(), {0, 0, -3}}, kCamera));
}

}  // namespace
}  // namespace framewise
