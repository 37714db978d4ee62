// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/surface_pyramid.h"

#include <gtest/gtest.h>

#include "framewise/registration/scenes_for_tests.h"

namespace framewise {
namespace {

using testing::depth_of;
using testing::test_camera;
using testing::TestScene;

Eigen::Vector3d normal_at(const Surface& surface, int u, int v) {
  const std::size_t i = static_cast<std::size_t>(v) * surface.grid.width + u;
  return {surface.nx[i], surface.ny[i], surface.nz[i]};
}

TEST(SurfacePyramid, FindsAPlaneExactlyAtEveryLevelAndThroughADistortingLens) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.2, 1).normalized();
  const TestScene scene{{{normal, 2.0}}, {}};
  for (const double k1 : {0.0, -0.2}) {
    Camera camera = test_camera();
    camera.distortion = {k1, 0.05, 0, 0, 0};
    const SurfacePyramid pyramid = SurfaceMaker(camera, {})(depth_of(scene, camera, Pose()));
    ASSERT_EQ(pyramid.size(), 3u);
    for (const Surface& surface : pyramid) {
      EXPECT_GT(surface.known, 0.9 * surface.grid.size());
      for (int v = 5; v < surface.grid.height - 5; v += 3)
        for (int u = 5; u < surface.grid.width - 5; u += 3) {
          const std::size_t i = static_cast<std::size_t>(v) * surface.grid.width + u;
          ASSERT_LT((normal_at(surface, u, v) - normal).norm(), 2e-3) << u << " " << v;
          ASSERT_NEAR(surface.distance[i], 2.0, 2e-3);
        }
    }
  }
}

TEST(SurfacePyramid, KeepsSurfacesBesideAnEdgeApart) {
  const Camera camera = test_camera();
  cv::Mat depth(camera.height, camera.width, CV_32F, cv::Scalar(1));
  depth.colRange(camera.width / 2, camera.width).setTo(2);
  const Surface surface = SurfaceMaker(camera, {})(depth)[0];
  for (int v = 8; v < surface.grid.height - 8; ++v)
    for (int u = 8; u < surface.grid.width - 8; ++u) {
      const float w = surface.inverse_depth[static_cast<std::size_t>(v) * surface.grid.width + u];
      if (w > 0) {
        ASSERT_NEAR(w, u < surface.grid.width / 2 ? 1 : 0.5, 1e-4) << u;
      }
    }
}

TEST(SurfacePyramid, HasNoPlaneWhereNothingIsKnown) {
  const Camera camera = test_camera();
  const SurfaceMaker maker(camera, {});
  for (const float z : {std::nanf(""), 0.0f, -1.0f, std::numeric_limits<float>::infinity(), 1000.0f}) {
    const SurfacePyramid pyramid = maker(cv::Mat(camera.height, camera.width, CV_32F, cv::Scalar(z)));
    for (const Surface& surface : pyramid) EXPECT_EQ(surface.known, 0u) << z;
  }
}

TEST(SurfacePyramid, OfAnImageTooSmallForANeighbourhoodIsEmpty) {
  for (const int size : {1, 2, 5}) {
    const Camera camera = test_camera(size, size);
    EXPECT_TRUE(SurfaceMaker(camera, {})(cv::Mat(size, size, CV_32F, cv::Scalar(1))).empty());
  }
}

TEST(SurfacePyramid, RefusesImagesOfAnotherSizeOrTypeAndCamerasWithoutAPinhole) {
  Camera camera = test_camera();
  const SurfaceMaker maker(camera, {});
  EXPECT_THROW(maker(cv::Mat(10, 10, CV_32F, cv::Scalar(1))), std::invalid_argument);
  EXPECT_THROW(maker(cv::Mat(camera.height, camera.width, CV_16U, cv::Scalar(1))), std::invalid_argument);
  EXPECT_THROW(maker(cv::Mat()), std::invalid_argument);
  camera.model = CameraModel::kEquirectangular;
  EXPECT_THROW(SurfaceMaker(camera, {}), std::invalid_argument);
}

TEST(SurfaceOptions, NameWhatIsWrong) {
  SurfaceOptions options;
  options.reach_px = 9;
  try {
    options.check();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("reach_px"), std::string::npos);
  }
}

}  // namespace
}  // namespace framewise
