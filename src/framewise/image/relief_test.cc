// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/relief.h"

#include <gtest/gtest.h>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

// Every known pixel of a plane, away from where it vanishes.
template <typename Expected>
void expect_on_planes(const Expected& expected,
                      cv::Mat (*image_of)(const cv::Mat&, const DepthRays&, const ReliefOptions&)) {
  ReliefOptions options;
  options.distance_px = 2;
  options.light = {0.4, -0.7, -0.6};
  for (const DepthRays& rays : all_rays())
    for (const Eigen::Vector3d& direction : {Eigen::Vector3d(0, 0, 1), {0.3, -0.2, 1}, {-0.5, 0.4, 1}}) {
      const Eigen::Vector3d normal = direction.normalized();
      const cv::Mat image = image_of(plane_depth(rays, normal, 2), rays, options);
      int seen = 0;
      for (int v = 0; v < image.rows; ++v)
        for (int u = 0; u < image.cols; ++u) {
          const Bearing b = *rays.camera.bearing(Eigen::Vector2d(u, v));
          if (std::isnan(image.at<float>(v, u)) || normal.dot(b) < 0.3) continue;
          ++seen;
          ASSERT_NEAR(image.at<float>(v, u), expected(rays, -normal, b, options), 2e-4)
              << name_of(rays.camera.model) << " " << u << " " << v;
        }
      EXPECT_GT(seen, 100);
    }
}

TEST(NormalImage, OfAPlaneIsItsNormalsPartTowardsTheCamera) {
  expect_on_planes(
      [](const DepthRays& rays, const Eigen::Vector3d& normal, const Bearing& b, const ReliefOptions&) {
        return rays.kind == DepthRays::Kind::kSphere ? -normal.dot(b) : -normal.z();
      },
      normal_image);
}

TEST(ShadedRelief, OfAPlaneIsTheCosineToTheLight) {
  expect_on_planes(
      [](const DepthRays&, const Eigen::Vector3d& normal, const Bearing&, const ReliefOptions& options) {
        return std::max(0.0, normal.dot(options.light.normalized()));
      },
      shaded_relief);
}

TEST(NormalImage, IsThatOfTheDifferencesOfARoughSurface) {
  for (const DepthRays& rays : all_rays()) {
    if (rays.kind == DepthRays::Kind::kSphere) continue;
    const cv::Mat depth = random_depth(64, 48, 1);
    ReliefOptions options;
    options.distance_px = 1;
    const cv::Mat image = normal_image(depth, rays, options);
    for (int v = 1; v < 47; ++v)
      for (int u = 1; u < 63; ++u) {
        const PlainDifferences d = plain_differences(depth, rays, u, v, 1);
        const double turned = rays.camera.fy < 0 ? -1 : 1;
        const double expected = std::max(0.0, -turned * d.d0.cross(d.d1).normalized().z());
        ASSERT_NEAR(image.at<float>(v, u), expected, 1e-5) << name_of(rays.camera.model);
      }
  }
}

TEST(Relief, IsUnknownAtTheBorderAndBesideTheUnknown) {
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  cv::Mat depth = random_depth(64, 48, 2);
  depth.at<float>(20, 20) = kNoDepth;
  EXPECT_EQ(count_unknown(normal_image(depth, rays, {})), 64 * 48 - 56 * 40 + 4);
  EXPECT_EQ(count_unknown(shaded_relief(depth, rays, {})), 64 * 48 - 56 * 40 + 4);
}

TEST(Relief, RefusesBadOptions) {
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  const cv::Mat depth = random_depth(64, 48, 3);
  ReliefOptions options;
  options.light = {0, 0, 0};
  EXPECT_THROW(shaded_relief(depth, rays, options), std::invalid_argument);
  options = {};
  options.distance_px = 0;
  EXPECT_THROW(normal_image(depth, rays, options), std::invalid_argument);
  EXPECT_THROW(normal_image({}, rays, {}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
