// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "framewise/image/depth_rays.h"

// Cameras, surfaces and the definitions written plainly, for the tests of the depth images.
namespace framewise {

constexpr float kNoDepth = std::numeric_limits<float>::quiet_NaN();

inline Camera pinhole_camera(int width = 64, int height = 48) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.fx = 0.82 * width;
  camera.fy = 0.84 * width;
  camera.cx = 0.49 * width;
  camera.cy = 0.52 * height;
  return camera;
}

inline Camera distorted_camera() {
  Camera camera = pinhole_camera();
  camera.distortion = {0.26, -0.95, -0.005, 0.003, 1.16};
  return camera;
}

inline Camera fisheye_camera() {
  Camera camera = pinhole_camera();
  camera.model = CameraModel::kFisheye;
  camera.fx = camera.fy = 30;
  camera.distortion = {0.01, -0.002, 0.001, 0.0005, 0};
  return camera;
}

inline Camera equirectangular_camera(int width = 64, int height = 48) {
  Camera camera;
  camera.model = CameraModel::kEquirectangular;
  camera.width = width;
  camera.height = height;
  camera.theta_range = {0.2, 2.6};
  return camera;
}

// Every kind of camera with every type of depth it can have.
inline std::vector<DepthRays> all_rays() {
  Camera upside_down = pinhole_camera();
  upside_down.fy = -upside_down.fy;
  return {{pinhole_camera(), DepthType::kZ},
          {pinhole_camera(), DepthType::kRange},
          {upside_down, DepthType::kZ},
          {distorted_camera(), DepthType::kZ},
          {distorted_camera(), DepthType::kRange},
          {fisheye_camera(), DepthType::kRange},
          {equirectangular_camera(), DepthType::kRange}};
}

inline Eigen::Vector3d ray_of(const DepthRays& rays, int u, int v) {
  const Bearing b = *rays.camera.bearing(Eigen::Vector2d(u, v));
  return rays.type == DepthType::kZ ? Eigen::Vector3d(b / b.z()) : Eigen::Vector3d(b);
}

// A smooth, bent surface with 2 % of noise that no two pixels share.
inline cv::Mat random_depth(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  cv::Mat depth(height, width, CV_32F);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      depth.at<float>(v, u) = static_cast<float>(2 + std::sin(0.1 * u) + 0.5 * std::cos(0.13 * v) +
                                                 0.04 * (random() / 4294967296.0 - 0.5));
  return depth;
}

// The depths of a plane normal . X = offset; NaN where a ray does not meet it.
inline cv::Mat plane_depth(const DepthRays& rays, const Eigen::Vector3d& normal, double offset) {
  cv::Mat depth(rays.camera.height, rays.camera.width, CV_32F);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double t = offset / normal.dot(ray_of(rays, u, v));
      depth.at<float>(v, u) = t > 0 ? static_cast<float>(t) : kNoDepth;
    }
  return depth;
}

// d0, d1, d2, d3 of flexion.h in double precision.
struct PlainDifferences {
  Eigen::Vector3d d0, d1, d2, d3;
};
inline PlainDifferences plain_differences(const cv::Mat& depth, const DepthRays& rays, int u, int v, int n) {
  const auto point = [&](int x, int y) -> Eigen::Vector3d {
    return depth.at<float>(y, x) * ray_of(rays, x, y);
  };
  return {point(u, v + n) - point(u, v - n), point(u + n, v) - point(u - n, v),
          point(u - n, v + n) - point(u + n, v - n), point(u + n, v + n) - point(u - n, v - n)};
}

inline bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() && b.isContinuous() &&
         std::equal(a.datastart, a.dataend, b.datastart);
}

inline int count_unknown(const cv::Mat& image) {
  int count = 0;
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u) count += std::isnan(image.at<float>(v, u));
  return count;
}

// Largest difference of two images; infinite where only one of them is NaN.
inline double largest_difference(const cv::Mat& a, const cv::Mat& b) {
  double most = 0;
  for (int v = 0; v < a.rows; ++v)
    for (int u = 0; u < a.cols; ++u) {
      const float x = a.at<float>(v, u), y = b.at<float>(v, u);
      if (std::isnan(x) && std::isnan(y)) continue;
      if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::infinity();
      most = std::max(most, std::abs(double{x} - y));
    }
  return most;
}

}  // namespace framewise
