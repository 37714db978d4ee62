// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/rgbd_sensor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "framewise/geometry/so3.h"
#include "framewise/simulation/mesh_builder.h"

namespace framewise {
namespace {

RgbdOptions small_sensor() {
  RgbdOptions options;
  options.camera = {CameraModel::kPinhole, 80, 60, 66, 66, 39.5, 29.5, {}, {}};
  return options;
}

// A white wall x = 3 that shows to the camera at the origin looking along x.
Scene wall() {
  Scene scene;
  MeshBuilder builder(scene, 1);
  builder.quad({3, 6, -6}, {0, -12, 0}, {0, 0, 12}, {Texture::kPaint, {0.5f, 0.5f, 0.5f}, {}, 1});
  for (Vertex& vertex : scene.vertices) vertex.light = {1, 1, 1};
  return scene;
}

Pose looking_along_x() {
  Pose pose;
  pose.R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return pose;
}

TEST(RgbdSensor, DepthIsAlongTheAxisAndNotAlongTheRay) {
  const Scene scene = wall();
  const Frame frame = RgbdSensor(small_sensor()).render(RayTracer(scene), looking_along_x());
  for (int v = 0; v < 60; ++v)
    for (int u = 0; u < 80; ++u) ASSERT_NEAR(frame.depth.at<float>(v, u), 3, 1e-6);
}

TEST(RgbdSensor, DepthOfASlantedViewIsThatOfTheCentreOfThePixel) {
  const Scene scene = wall();
  const RgbdOptions options = small_sensor();
  Pose pose = looking_along_x();
  pose.R = so3_exp({0, 0.2, 0.4}) * pose.R;
  pose.t = {0.2, -0.1, 0.3};
  const Frame frame = RgbdSensor(options).render(RayTracer(scene), pose);
  for (int v = 0; v < 60; v += 7) {
    for (int u = 0; u < 80; u += 7) {
      const Bearing ray = *options.camera.bearing({u, v});
      const double along_ray = (3 - pose.t.x()) / (pose.R * ray).x();
      EXPECT_NEAR(frame.depth.at<float>(v, u), along_ray * ray.z(), 2e-6);
    }
  }
}

TEST(RgbdSensor, BeyondItsReachDepthIsUnknownAndColorIsNot) {
  const Scene scene = wall();
  RgbdOptions options = small_sensor();
  options.max_depth = 2.9;
  const Frame frame = RgbdSensor(options).render(RayTracer(scene), looking_along_x());
  EXPECT_TRUE(std::isnan(frame.depth.at<float>(30, 40)));
  EXPECT_GT(frame.gray.at<std::uint8_t>(30, 40), 100);
}

// Black from y = at on, white before it; both shine.
Scene black_beside_white(float at) {
  Scene scene;
  MeshBuilder builder(scene, 20);
  Material white{Texture::kPlain, {1, 1, 1}, {}, 1}, black = white;
  white.emission = black.emission = 1;
  black.a = {};
  builder.quad({3, at, -6}, {0, -12, 0}, {0, 0, 12}, white);
  builder.quad({3, at + 12, -6}, {0, -12, 0}, {0, 0, 12}, black);
  return scene;
}

TEST(RgbdSensor, ABorderMovesThroughAPixelInEighths) {
  constexpr float kPixel = 3.0f / 66;  // of the wall
  for (float place = -1; place < 1; place += 0.0371f) {
    const Scene scene = black_beside_white(-place * kPixel);
    RgbdOptions options = small_sensor();
    const auto border = [&] {
      const cv::Mat light = RgbdSensor(options).light(RayTracer(scene), std::array{looking_along_x()});
      double dark = 0;
      for (int u = 0; u < 80; ++u) dark += 1 - light.at<cv::Vec3f>(30, u)[1];
      return dark - 40;  // columns to the right of the middle
    };
    EXPECT_NEAR(border(), place, 0.07);
    options.edge_samples = 1;
    EXPECT_NEAR(border(), place, 0.51);
  }
}

TEST(RgbdSensor, RefusesOptionsThatMakeNoSensor) {
  RgbdOptions options = small_sensor();
  options.edge_samples = 3;
  EXPECT_THROW(RgbdSensor{options}, std::invalid_argument);
  options = small_sensor();
  options.camera.fx = 0;
  EXPECT_THROW(RgbdSensor{options}, std::invalid_argument);
  options = small_sensor();
  options.max_depth = -1;
  EXPECT_THROW(RgbdSensor{options}, std::invalid_argument);
}

}  // namespace
}  // namespace framewise
