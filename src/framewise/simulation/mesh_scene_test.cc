// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/mesh_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/simulation/simulate.h"

namespace framewise {
namespace {

// A square of 2 m x 2 m at height z, seen from above.
Mesh square(float z) {
  Mesh mesh;
  mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  mesh.normals.assign(4, Eigen::Vector3f::UnitZ());
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.material_of_triangle = {0, 0};
  mesh.materials.resize(1);
  return mesh;
}

// One look straight down from 2 m above the ground.
SimulateOptions looking_down(const Mesh& mesh) {
  SimulateOptions options;
  options.mesh = std::make_shared<const Mesh>(mesh);
  options.width = 64;
  options.height = 48;
  Pose pose;
  pose.R << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  pose.t = {0, 0, 2};
  options.poses.add(0, pose);
  options.poses.add(1, pose);
  options.frames = 1;
  return options;
}

Frame only_frame(const SimulateOptions& options) {
  Frame frame;
  simulate(options, [&](const SimulatedFrame& simulated) {
    frame = simulated.frame;
    return true;
  });
  return frame;
}

TEST(MeshScene, DepthIsThatOfTheModel) {
  const Frame frame = only_frame(looking_down(square(0.5f)));
  EXPECT_FLOAT_EQ(frame.depth.at<float>(24, 32), 1.5f);
  EXPECT_GT(frame.gray.at<std::uint8_t>(24, 32), 40) << "lit from all around";
}

TEST(MeshScene, WhatShinesShowsItsPlainColour) {
  Mesh mesh = square(0);
  mesh.materials[0].emission = {0.5f, 0.2f, 0};
  const cv::Mat color = only_frame(looking_down(mesh)).color;
  for (int u = 20; u < 44; ++u) EXPECT_EQ(color.at<cv::Vec3b>(24, u), cv::Vec3b(0, 124, 188));
}

TEST(MeshScene, ColoursOfVerticesRunBetweenThem) {
  Mesh mesh = square(0);
  mesh.materials[0].emission = {1, 1, 1};
  mesh.colors = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};  // red towards +x
  const cv::Mat color = only_frame(looking_down(mesh)).color;
  EXPECT_EQ(color.at<cv::Vec3b>(24, 32)[0], 0);
  EXPECT_NEAR(color.at<cv::Vec3b>(24, 32)[2], 188, 4) << "half the light";
  EXPECT_LT(color.at<cv::Vec3b>(24, 20)[2], color.at<cv::Vec3b>(24, 44)[2]);
}

TEST(MeshScene, ImagesLieWhereTheirCoordinatesSay) {
  Mesh mesh = square(0);
  mesh.materials[0].color = {1, 1, 1};
  mesh.materials[0].image = cv::Mat(32, 32, CV_8UC3, cv::Scalar(0, 0, 0));
  mesh.materials[0].image(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar(0, 255, 0));  // towards -x, +y
  const cv::Mat color = only_frame(looking_down(mesh)).color;
  EXPECT_GT(color.at<cv::Vec3b>(12, 20)[1], 100) << "up in the picture is +y";
  for (const auto& [u, v] : {std::pair(44, 12), {20, 36}, {44, 36}})
    EXPECT_EQ(color.at<cv::Vec3b>(v, u)[1], 0);
}

// Whatever the size of the model, and whichever the way round it.
TEST(MeshScene, PathsAroundAModelSeeItInEveryFrame) {
  for (const float size : {0.02f, 1.0f, 30.0f}) {
    Mesh mesh = square(0);
    for (auto& x : mesh.positions) x = size * Eigen::Vector3f(0, x.x(), x.y()) + Eigen::Vector3f(7, -5, 3);
    for (const char* path : {"orbit", "handheld"}) {
      SimulateOptions options;
      options.mesh = std::make_shared<const Mesh>(mesh);
      options.path = path;
      options.width = 32;
      options.height = 24;
      options.rate_hz = 0.07;
      options.frames = 9;
      EXPECT_TRUE(is_anything_in_view(options));
      int seen = 0;
      simulate(options, [&](const SimulatedFrame& simulated) {
        seen += cv::countNonZero(simulated.frame.depth == simulated.frame.depth) > 0;
        return true;
      });
      EXPECT_GE(seen, 8) << path << " of " << size << " m";  // a sheet may be seen edge on
    }
  }
}

TEST(MeshScene, SaysWhereNothingIsInView) {
  SimulateOptions options = looking_down(square(0));
  EXPECT_TRUE(is_anything_in_view(options));
  options.poses.world_from_cam[0].t.x() = options.poses.world_from_cam[1].t.x() = 500;
  EXPECT_FALSE(is_anything_in_view(options));
}

TEST(MeshScene, RefusesAMeshWithoutAFace) {
  Mesh mesh = square(0);
  for (auto& x : mesh.positions) x.y() = 0;
  EXPECT_THROW(mesh_scene(mesh, {}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
