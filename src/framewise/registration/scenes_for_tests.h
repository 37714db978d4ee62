// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/geometry/so3.h"

// Depth images of walls and spheres.
namespace framewise::testing {

struct Wall {
  Eigen::Vector3d normal;
  double distance;  // normal . x = distance
};
struct Ball {
  Eigen::Vector3d centre;
  double radius;
};
struct TestScene {
  std::vector<Wall> walls;
  std::vector<Ball> balls;
};

inline Camera test_camera(int width = 320, int height = 240) {
  Camera camera;
  camera.width = width, camera.height = height;
  camera.fx = camera.fy = 0.82 * width;
  camera.cx = (width - 1) / 2.0, camera.cy = (height - 1) / 2.0;
  return camera;
}

// Share along a ray from `from`; infinite where it meets nothing.
inline double meet(const TestScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : scene.walls) {
    const double share = (wall.distance - wall.normal.dot(from)) / wall.normal.dot(ray);
    if (share > 0 && share < nearest) nearest = share;
  }
  for (const Ball& ball : scene.balls) {
    const Eigen::Vector3d to = ball.centre - from;
    const double b = to.dot(ray), a = ray.squaredNorm(), c = to.squaredNorm() - ball.radius * ball.radius;
    const double root = b * b - a * c;
    if (root < 0) continue;
    const double share = (b - std::sqrt(root)) / a;
    if (share > 0 && share < nearest) nearest = share;
  }
  return nearest;
}

inline cv::Mat depth_of(const TestScene& scene, const Camera& camera, const Pose& world_from_cam) {
  cv::Mat depth(camera.height, camera.width, CV_32F);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto bearing = camera.bearing(Eigen::Vector2d(u, v));
      const double z =
          bearing ? meet(scene, world_from_cam.t, world_from_cam.R * (*bearing / bearing->z())) : 0;
      depth.at<float>(v, u) = static_cast<float>(z > 0 && z < 100 ? z : std::nan(""));
    }
  return depth;
}

// The corner of a room, with two balls in it: everything about the camera's motion shows.
inline TestScene furnished_room() {
  return {{{{1, 0, 0}, 1.6}, {{0, 1, 0}, 1.2}, {{0, 0, 1}, 3.0}, {{-1, 0, 0.2}, 1.9}},
          {{{-0.4, 0.3, 2.2}, 0.4}, {{0.5, -0.4, 2.4}, 0.5}}};
}

// A normal number of mean 0 and variance 1, alike on every platform.
inline double normal_number(std::mt19937_64& random) {
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * std::log(uniform()));
  return radius * std::cos(2 * M_PI * uniform());
}

inline cv::Mat with_noise(const cv::Mat& depth, const DepthNoise& noise, std::mt19937_64& random) {
  cv::Mat noisy = depth.clone();
  for (float& z : cv::Mat_<float>(noisy)) z += static_cast<float>(noise.sigma(z) * normal_number(random));
  return noisy;
}

inline Pose small_motion(double scale) {
  return {so3_exp(scale * Eigen::Vector3d(0.01, -0.02, 0.015)), scale * Eigen::Vector3d(0.02, -0.01, 0.03)};
}

}  // namespace framewise::testing
