// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/odometer.h"

namespace framewise {

// What a camera sees of walls that stand across the z axis, textured with smooth noise, nearer ones before
// farther ones; rendered by casting a ray through each pixel.
class Boxes {
 public:
  Boxes() {
    cv::Mat coarse(260, 260, CV_8U);
    cv::RNG rng(11);
    rng.fill(coarse, cv::RNG::UNIFORM, 0, 256);
    cv::resize(coarse, texture_, {}, 8, 8, cv::INTER_CUBIC);
  }

  static Camera camera() { return {CameraModel::kPinhole, 320, 240, 250, 250, 159.5, 119.5}; }

  Frame frame(const Pose& world_from_cam, double time) const {
    const Camera c = camera();
    Frame frame;
    frame.time = time;
    frame.gray.create(c.height, c.width, CV_8U);
    frame.depth.create(c.height, c.width, CV_32F);
    for (int v = 0; v < c.height; ++v)
      for (int u = 0; u < c.width; ++u) {
        const Eigen::Vector3d ray((u - c.cx) / c.fx, (v - c.cy) / c.fy, 1);
        cast(world_from_cam, ray, frame.gray.at<std::uint8_t>(v, u), frame.depth.at<float>(v, u));
      }
    return frame;
  }

  // Frames of a path: world_from_cam of each, 0.1 s apart.
  FrameSource source(std::size_t size, std::function<Pose(std::size_t)> path) const {
    return {size, [this, path](std::size_t i) { return frame(path(i), 0.1 * static_cast<double>(i)); }, {}};
  }

 private:
  // Walls at z, from x0 to x1, endless in y.
  struct Wall {
    double z, x0, x1;
  };
  static constexpr Wall kWalls[] = {{1.6, -0.3, 0.25}, {2.2, 0.7, 1.6}, {2.4, -1.9, -0.8}, {3.2, -1e3, 1e3}};

  void cast(const Pose& world_from_cam, const Eigen::Vector3d& ray, std::uint8_t& gray, float& depth) const {
    const Eigen::Vector3d direction = world_from_cam.R * ray;
    for (const Wall& wall : kWalls) {
      const double s = (wall.z - world_from_cam.t.z()) / direction.z();
      if (!(s > 0)) continue;
      const Eigen::Vector3d x = world_from_cam.t + s * direction;
      if (x.x() < wall.x0 || x.x() > wall.x1) continue;
      depth = static_cast<float>(s);
      gray = texture_at(110 * x.x() + 371 * wall.z, 110 * x.y());
      return;
    }
    gray = 0, depth = std::numeric_limits<float>::quiet_NaN();
  }

  std::uint8_t texture_at(double u, double v) const {
    const double cols = texture_.cols - 1, rows = texture_.rows - 1;
    u = std::fmod(std::fmod(u, cols) + cols, cols), v = std::fmod(std::fmod(v, rows) + rows, rows);
    const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
    const double a = u - u0, b = v - v0;
    const auto at = [&](int x, int y) { return static_cast<double>(texture_.at<std::uint8_t>(y, x)); };
    return cv::saturate_cast<std::uint8_t>((1 - b) * ((1 - a) * at(u0, v0) + a * at(u0 + 1, v0)) +
                                           b * ((1 - a) * at(u0, v0 + 1) + a * at(u0 + 1, v0 + 1)));
  }

  cv::Mat texture_;
};

}  // namespace framewise
