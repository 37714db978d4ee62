// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/registration.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/geometry/so3.h"
#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

// A pixel is 1 / 64 of the depth: shifts are whole pixels at round depths.
Camera camera_64() { return {CameraModel::kPinhole, 64, 48, 64, 64, 31.5, 23.5, {}, {}}; }

DepthCamera beside(double x, double y = 0) { return {camera_64(), {Eigen::Matrix3d::Identity(), {x, y, 0}}}; }

cv::Mat wall(float z, int width = 64, int height = 48) {
  return cv::Mat(height, width, CV_32F, cv::Scalar(z));
}

TEST(DepthRegistration, TheSameCameraKeepsEveryPixel) {
  const DepthRegistration registration(camera_64(), beside(0));
  cv::Mat depth = random_depth(64, 48, 1);
  depth.at<float>(20, 10) = kNoDepth;
  EXPECT_EQ(largest_difference(registration(depth), depth), 0);
}

TEST(DepthRegistration, AWallMovesByFocalLengthTimesBaselineOverDepth) {
  // The depth camera stands 1/8 m to the right: a wall 2 m away appears 64 / 8 / 2 = 4 pixels to the right.
  const DepthRegistration registration(camera_64(), beside(0.125));
  cv::Mat depth = wall(2);
  depth.at<float>(7, 30) = kNoDepth;
  const cv::Mat registered = registration(depth);
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u) {
      const bool known = u >= 4 && !(v == 7 && u == 34);
      ASSERT_EQ(std::isnan(registered.at<float>(v, u)), !known) << u << ' ' << v;
      if (!known) continue;
      ASSERT_EQ(registered.at<float>(v, u), 2);
    }
}

TEST(DepthRegistration, TheNearerSurfaceHidesTheFarther) {
  cv::Mat depth = wall(4);
  depth(cv::Rect(20, 10, 8, 8)) = 1;  // moves by 8 pixels, the wall by 2
  const cv::Mat registered = DepthRegistration(camera_64(), beside(0.125))(depth);
  for (int u = 2; u < 64; ++u) {
    const float z = registered.at<float>(12, u);
    const bool box = u >= 28 && u < 36,
               hole = u >= 22 && u < 30;  // behind the box's old place nothing was seen
    if (box)
      EXPECT_EQ(z, 1) << u;
    else if (hole)
      EXPECT_TRUE(std::isnan(z)) << u;
    else
      EXPECT_EQ(z, 4) << u;
  }
}

TEST(DepthRegistration, ASurfaceStaysClosedWhereTheCameraResolvesMore) {
  Camera fine = camera_64();
  fine.width *= 3, fine.height *= 3, fine.fx *= 3, fine.fy *= 3;
  fine.cx = 3 * 31.5 + 1, fine.cy = 3 * 23.5 + 1;
  const cv::Mat registered = DepthRegistration(fine, beside(0))(wall(2));
  EXPECT_EQ(count_unknown(registered), 0);
}

TEST(DepthRegistration, ATurnedCameraSeesTheWallSlanted) {
  const double angle = 0.2;
  DepthCamera turned{camera_64(), {so3_exp({0, angle, 0}), {0.1, -0.05, 0.02}}};
  const DepthRays rays(camera_64(), DepthType::kZ);
  const cv::Mat registered = DepthRegistration(camera_64(), turned)(wall(2));
  // The wall z = 2 of the depth camera, in the camera: n . (X - t) = 2, n the turned axis.
  const Eigen::Vector3d n = turned.cam_from_depth_cam.R.col(2);
  const cv::Mat expected = plane_depth(rays, n, 2 + n.dot(turned.cam_from_depth_cam.t));
  int compared = 0;
  for (int v = 4; v < 44; ++v)
    for (int u = 20; u < 60; ++u) {
      const float z = registered.at<float>(v, u);
      if (std::isnan(z)) continue;
      ++compared;
      // Half a pixel along the slope is the most a patch is wrong.
      ASSERT_NEAR(z, expected.at<float>(v, u), 0.6 * 2.4 * std::tan(2 * angle) / 64) << u << ' ' << v;
    }
  EXPECT_GT(compared, 40 * 40 * 0.95);
}

TEST(DepthRegistration, FollowsDistortedCameras) {
  const Camera distorted = distorted_camera();
  const cv::Mat same = DepthRegistration(distorted, {distorted, {}})(wall(2));
  EXPECT_LT(count_unknown(same), 64 * 48 / 100);
  for (int v = 5; v < 43; ++v)
    for (int u = 5; u < 59; ++u) {
      if (std::isnan(same.at<float>(v, u))) continue;
      ASSERT_NEAR(same.at<float>(v, u), 2, 1e-6);
    }
}

TEST(DepthRegistration, KnowsNothingBehindAndMuchTooNear) {
  DepthCamera ahead = beside(0);
  ahead.cam_from_depth_cam.t.z() = -3;  // the camera stands 3 m further on
  EXPECT_EQ(count_unknown(DepthRegistration(camera_64(), ahead)(wall(2))), 64 * 48);
  EXPECT_EQ(count_unknown(DepthRegistration(camera_64(), ahead)(wall(3.0001f))), 64 * 48);
  EXPECT_EQ(count_unknown(DepthRegistration(camera_64(), beside(0))(wall(kNoDepth))), 64 * 48);
  EXPECT_EQ(count_unknown(DepthRegistration(camera_64(), beside(0))(wall(-1))), 64 * 48);
}

TEST(DepthRegistration, RefusesWhatIsNoDepthImageOfItsCamera) {
  const DepthRegistration registration(camera_64(), beside(0));
  EXPECT_THROW(registration(wall(2, 63, 48)), std::invalid_argument);
  EXPECT_THROW(registration(cv::Mat(48, 64, CV_16U)), std::invalid_argument);
  EXPECT_THROW(DepthRegistration(Camera(), beside(0)), std::invalid_argument);
  EXPECT_THROW(DepthRegistration(camera_64(), {equirectangular_camera(), {}}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
