// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/pose.h"
#include "framewise/image/frame.h"
#include "framewise/simulation/ray_tracer.h"

namespace framewise {

struct RgbdOptions {
  Camera camera{CameraModel::kPinhole, 640, 480, 525, 525, 319.5, 239.5, {}, {}};
  double max_depth = 10;  // farther is invalid (m)
  // Rays to a pixel beside a border of two surfaces: 4 tell to an eighth of a pixel where it runs, with 1 it
  // has steps. Textures filter themselves.
  int edge_samples = 4;
  double exposure = 1;  // times as much light as turns 1.0 into white
  double headlamp = 0;  // a lamp at the camera: the light it throws on what faces it at 1 m; 0: none

  void check() const;
};

// Rays through the centres of pixels, row by row; z is 1 where the camera allows.
struct PixelRays {
  int width = 0, height = 0;
  std::vector<float> x, y, z;

  Eigen::Vector3f operator()(int u, int v) const {
    const std::size_t i = static_cast<std::size_t>(v) * width + u;
    return {x[i], y[i], z[i]};
  }
  void push_back(const Eigen::Vector3f& ray) {
    x.push_back(ray.x());
    y.push_back(ray.y());
    z.push_back(ray.z());
  }
};

// What is in the middle of each pixel.
struct SurfaceImage {
  cv::Mat depth;   // CV_32F, z in metres however far, NaN where there is nothing
  cv::Mat facing;  // CV_32F, cosine between the ray and the surface's normal: 1 seen head on, 0 grazing
};

// A camera that measures colour and depth of the same ray, without blur or noise.
class RgbdSensor {
 public:
  explicit RgbdSensor(const RgbdOptions& options);

  const RgbdOptions& options() const { return options_; }

  // What is seen from a pose. Depth is exact, along the ray through the centre of the pixel. The frame's time
  // is left to the caller. Works on all threads of the caller's arena; the bytes do not depend on how many.
  Frame render(const RayTracer& tracer, const Pose& world_from_cam) const;

  // The light that falls into each pixel, CV_32FC3 blue green red, linear, 1 for white and as bright as it
  // is beyond. One pose, or one for each row.
  cv::Mat light(const RayTracer& tracer, std::span<const Pose> world_from_cam_of_row) const;

  // One instant of a mean: where each row looks from (or all), and how far beside the centres of the pixels.
  struct Instant {
    std::vector<Pose> world_from_cam_of_row;
    std::array<float, 2> offset;
  };

  // The mean of the light over instants, by one ray a pixel and instant. What a surface shows, and the
  // headlamp on it, is taken from the view of the middle where that sees the same place to half a pixel:
  // looking at textures again is most of the work.
  cv::Mat mean_light(const RayTracer& tracer, const Pose& world_from_cam_in_the_middle,
                     std::span<const Instant> instants) const;

  SurfaceImage surface(const RayTracer& tracer, const Pose& world_from_cam) const;

 private:
  RgbdOptions options_;
  PixelRays rays_in_cam_, straight_rays_;
};

}  // namespace framewise
