// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/depth_rays.h"

#include <gtest/gtest.h>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

TEST(ZFromRange, IsTheForwardPartOfTheRay) {
  for (const Camera& camera : {pinhole_camera(), distorted_camera(), fisheye_camera()}) {
    const DepthRays as_range(camera, DepthType::kRange), as_z(camera, DepthType::kZ);
    const Eigen::Vector3d normal(0.1, -0.2, 1);
    EXPECT_LT(largest_difference(z_from_range(plane_depth(as_range, normal, 2), camera),
                                 plane_depth(as_z, normal, 2)),
              1e-5)
        << name_of(camera.model);
  }
}

TEST(ZFromRange, IsUnknownWhereTheRangeIsAndWhereTheRayLooksBack) {
  const Camera camera = equirectangular_camera(8, 4);
  cv::Mat range(4, 8, CV_32F, cv::Scalar(2));
  range.at<float>(1, 4) = kNoDepth;
  const cv::Mat z = z_from_range(range, camera);
  EXPECT_EQ(count_unknown(z), 16 + 1);
  EXPECT_TRUE(std::isnan(z.at<float>(1, 0)));
  EXPECT_GT(z.at<float>(1, 3), 0);
  EXPECT_THROW(z_from_range(cv::Mat(4, 7, CV_32F), camera), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
