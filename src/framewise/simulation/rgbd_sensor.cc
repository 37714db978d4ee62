// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/rgbd_sensor.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace framewise {
namespace {

using Eigen::Vector3f;

constexpr int kTile = 32;
// Neighbours that differ by more than this (of 255) are drawn with more rays: at the border of two surfaces,
// and within one, where the texture is filtered already.
constexpr int kContrastOfSurfaces = 12, kContrastOfTexture = 40;
// A grid of four samples turned so that no two share a row or column (pixels from the centre).
constexpr float kSamples[4][2] = {{-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}};

// Display value of light 0 to 1 (IEC 61966-2-1), read from a table.
class DisplayCurve {
 public:
  DisplayCurve() {
    for (int i = 0; i < kSize; ++i) {
      const double c = (i + 0.5) / kSize;
      table_[i] =
          static_cast<float>(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055));
    }
  }
  float operator()(float light) const {
    return table_[std::clamp(static_cast<int>(light * kSize), 0, kSize - 1)];
  }

 private:
  static constexpr int kSize = 16384;
  std::array<float, kSize> table_;
};

// What the first pass leaves for the second.
struct Centres {
  cv::Mat color;     // CV_8UC3
  cv::Mat triangle;  // CV_32S
};

struct View {
  const RayTracer& tracer;
  const RgbdOptions& options;
  const std::vector<Vector3f>& rays_in_cam;
  Pose world_from_cam;
  Eigen::Matrix3f turn;
  Vector3f origin;
  float pixel_angle;
  const DisplayCurve& display;

  Vector3f ray_in_cam(int u, int v) const { return rays_in_cam[v * options.camera.width + u]; }

  bool is_one_surface(int triangle1, int triangle2) const {
    const auto& materials = tracer.scene().material_of_triangle;
    return triangle1 == triangle2 ||
           (triangle1 >= 0 && triangle2 >= 0 && materials[triangle1] == materials[triangle2]);
  }

  // The ray beside a pixel's centre, from the rays of its neighbours.
  Vector3f ray_in_cam(int u, int v, const float (&offset)[2]) const {
    const int u0 = std::max(u - 1, 0), u1 = std::min(u + 1, options.camera.width - 1);
    const int v0 = std::max(v - 1, 0), v1 = std::min(v + 1, options.camera.height - 1);
    Vector3f ray = ray_in_cam(u, v);
    if (u1 > u0) ray += offset[0] / static_cast<float>(u1 - u0) * (ray_in_cam(u1, v) - ray_in_cam(u0, v));
    if (v1 > v0) ray += offset[1] / static_cast<float>(v1 - v0) * (ray_in_cam(u, v1) - ray_in_cam(u, v0));
    return ray;
  }
};

// Display colour where a ray hits, with textures filtered over this part of a pixel.
Color shade(const View& view, const Hits8& hits, int i, const Vector3f& direction, float part_of_pixel) {
  const SurfacePoint at = view.tracer.surface_point(hits.triangle[i], hits.weight1[i], hits.weight2[i]);
  const float length = direction.norm();
  const float slant = std::max(0.1f, std::abs(at.normal.dot(direction)) / length);
  // Between the short and the long side of the pixel's foot on the surface.
  const float footprint = part_of_pixel * hits.t[i] * length * view.pixel_angle / std::sqrt(slant);
  const Color reflectance = albedo(*at.material, at.u, at.v, footprint);
  const Color seen = at.material->emission > 0 ? reflectance * at.material->emission : reflectance * at.light;
  const Color exposed = seen * static_cast<float>(view.options.exposure);
  return {view.display(exposed.r), view.display(exposed.g), view.display(exposed.b)};
}

cv::Vec3b to_bytes(const Color& display) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(x + 0.5f); };
  return {byte(display.b), byte(display.g), byte(display.r)};
}

// First pass: one ray through the centre of each pixel gives depth and a colour. Rays go in packets of 4 x 2
// pixels.
void trace_centres(const View& view, int u0, int v0, Centres& centres, cv::Mat& depth) {
  cv::Mat& color = centres.color;
  Rays8 rays;
  std::array<Vector3f, 8> directions;
  for (int i = 0; i < 8; ++i) {
    const int u = u0 + i % 4, v = v0 + i / 4;
    if (u < color.cols && v < color.rows) {
      directions[i] = view.turn * view.ray_in_cam(u, v);
      rays.set(i, view.origin, directions[i], 1e-3f, 1e4f);
    } else {
      rays.switch_off(i);
    }
  }
  Hits8 hits;
  view.tracer.intersect(rays, true, hits);
  for (int i = 0; i < 8; ++i) {
    const int u = u0 + i % 4, v = v0 + i / 4;
    if (u >= color.cols || v >= color.rows || hits.triangle[i] == kNoHit) continue;
    color.at<cv::Vec3b>(v, u) = to_bytes(shade(view, hits, i, directions[i], 1));
    centres.triangle.at<int>(v, u) = static_cast<int>(hits.triangle[i]);
    const Eigen::Vector3d ray = view.ray_in_cam(u, v).cast<double>();
    const double z =
        ray.z() * view.tracer.exact_t(hits.triangle[i], view.world_from_cam.t, view.world_from_cam.R * ray);
    if (z <= view.options.max_depth) depth.at<float>(v, u) = static_cast<float>(z);
  }
}

bool needs_more_rays(const View& view, const Centres& centres, int u, int v) {
  const cv::Mat& color = centres.color;
  cv::Vec3b low = color.at<cv::Vec3b>(v, u), high = low;
  const int triangle = centres.triangle.at<int>(v, u);
  bool one_surface = true;
  for (const auto& step : {cv::Point(-1, 0), cv::Point(1, 0), cv::Point(0, -1), cv::Point(0, 1)}) {
    const int x = std::clamp(u + step.x, 0, color.cols - 1), y = std::clamp(v + step.y, 0, color.rows - 1);
    const cv::Vec3b& c = color.at<cv::Vec3b>(y, x);
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], c[k]);
      high[k] = std::max(high[k], c[k]);
    }
    one_surface &= view.is_one_surface(triangle, centres.triangle.at<int>(y, x));
  }
  const int contrast = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  return contrast > (one_surface ? kContrastOfTexture : kContrastOfSurfaces);
}

// The mean of four rays in each of two pixels.
void trace_edges(const View& view, const std::array<cv::Point, 2>& pixels, int count, cv::Mat& color) {
  Rays8 rays;
  std::array<Vector3f, 8> directions;
  for (int i = 0; i < 8; ++i) {
    if (i / 4 < count) {
      directions[i] = view.turn * view.ray_in_cam(pixels[i / 4].x, pixels[i / 4].y, kSamples[i % 4]);
      rays.set(i, view.origin, directions[i], 1e-3f, 1e4f);
    } else {
      rays.switch_off(i);
    }
  }
  Hits8 hits;
  view.tracer.intersect(rays, true, hits);
  for (int pixel = 0; pixel < count; ++pixel) {
    Color sum;
    for (int i = 4 * pixel; i < 4 * pixel + 4; ++i)
      if (hits.triangle[i] != kNoHit) sum += shade(view, hits, i, directions[i], 0.6f);
    color.at<cv::Vec3b>(pixels[pixel].y, pixels[pixel].x) = to_bytes(sum * 0.25f);
  }
}

void refine_tile(const View& view, const cv::Rect& tile, const Centres& centres, cv::Mat& color) {
  std::array<cv::Point, 2> waiting;
  int count = 0;
  for (int v = tile.y; v < tile.y + tile.height; ++v) {
    for (int u = tile.x; u < tile.x + tile.width; ++u) {
      if (!needs_more_rays(view, centres, u, v)) continue;
      waiting[count++] = {u, v};
      if (count < 2) continue;
      trace_edges(view, waiting, count, color);
      count = 0;
    }
  }
  if (count > 0) trace_edges(view, waiting, count, color);
}

template <typename Function>
void for_each_tile(int width, int height, Function work) {
  tbb::parallel_for(
      tbb::blocked_range2d<int>(0, (height + kTile - 1) / kTile, 0, (width + kTile - 1) / kTile),
      [&](const auto& range) {
        for (int j = range.rows().begin(); j < range.rows().end(); ++j)
          for (int i = range.cols().begin(); i < range.cols().end(); ++i)
            work(cv::Rect(i * kTile, j * kTile, kTile, kTile) & cv::Rect(0, 0, width, height));
      });
}

}  // namespace

void RgbdOptions::check() const {
  camera.check();
  if (!(max_depth > 0))
    throw std::invalid_argument("max_depth is " + std::to_string(max_depth) +
                                ", expected a positive number of metres");
  if (edge_samples != 1 && edge_samples != 4)
    throw std::invalid_argument("edge_samples is " + std::to_string(edge_samples) + ", expected 1 or 4");
  if (!(exposure > 0))
    throw std::invalid_argument("exposure is " + std::to_string(exposure) + ", expected a positive number");
}

RgbdSensor::RgbdSensor(const RgbdOptions& options) : options_(options) {
  options_.check();
  rays_in_cam_.reserve(static_cast<std::size_t>(options_.camera.width) * options_.camera.height);
  for (int v = 0; v < options_.camera.height; ++v) {
    for (int u = 0; u < options_.camera.width; ++u) {
      const auto x = options_.camera.bearing({u, v});
      if (!x)
        throw std::invalid_argument("camera: no ray for pixel " + std::to_string(u) + " " +
                                    std::to_string(v) + ", expected one for each");
      const Bearing ray = x->z() > 0.01 ? Bearing(*x / x->z()) : *x;
      rays_in_cam_.push_back(ray.cast<float>());
    }
  }
}

Frame RgbdSensor::render(const RayTracer& tracer, const Pose& world_from_cam) const {
  const int width = options_.camera.width, height = options_.camera.height;
  static const DisplayCurve display;
  const Vector3f middle = rays_in_cam_[(height / 2) * width + width / 2],
                 beside = rays_in_cam_[(height / 2) * width + width / 2 - (width > 1)];
  const View view{tracer,
                  options_,
                  rays_in_cam_,
                  world_from_cam,
                  world_from_cam.R.cast<float>(),
                  world_from_cam.t.cast<float>(),
                  (middle - beside).norm(),
                  display};
  Frame frame;
  frame.depth = cv::Mat(height, width, CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  Centres centres{cv::Mat(height, width, CV_8UC3, cv::Scalar::all(0)),
                  cv::Mat(height, width, CV_32S, cv::Scalar(-1))};
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    for (int v = tile.y; v < tile.y + tile.height; v += 2)
      for (int u = tile.x; u < tile.x + tile.width; u += 4) trace_centres(view, u, v, centres, frame.depth);
  });
  frame.color = centres.color.clone();
  if (options_.edge_samples == 4)
    for_each_tile(width, height,
                  [&](const cv::Rect& tile) { refine_tile(view, tile, centres, frame.color); });
  cv::cvtColor(frame.color, frame.gray, cv::COLOR_BGR2GRAY);
  return frame;
}

}  // namespace framewise
