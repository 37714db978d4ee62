// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "framewise/simulation/rgbd_sensor.h"

// What the passes of RgbdSensor share: where its pixels look, and how bright what they meet is.
namespace framewise {

// Where a row of pixels is when it looks.
struct RowPose {
  Pose world_from_cam;
  Eigen::Matrix3f turn;
  Eigen::Vector3f origin;

  explicit RowPose(const Pose& pose)
      : world_from_cam(pose), turn(pose.R.cast<float>()), origin(pose.t.cast<float>()) {}
};

// Display values 0 to 255 of linear light from 0 to 1 (IEC 61966-2-1), read from a table.
class DisplayCurve {
 public:
  DisplayCurve();

  Color operator()(const Color& light) const {
    return {displayed(light.r), displayed(light.g), displayed(light.b)};
  }

 private:
  static constexpr int kSize = 16384;

  float displayed(float light) const {
    return table_[static_cast<int>(std::clamp(light * kSize, 0.0f, static_cast<float>(kSize - 1)))];
  }

  std::array<float, kSize> table_;
};
const DisplayCurve& display_curve();

struct View {
  const RayTracer& tracer;
  const RgbdOptions& options;
  const PixelRays& rays_in_cam;
  std::vector<RowPose> rows;
  float pixel_angle;
  bool rows_differ;  // in when they look
  const DisplayCurve& displayed = display_curve();
  std::array<float, 2> offset = {0, 0};  // of all rays from the centres of the pixels (pixels)

  // The ray beside a pixel's centre, from the rays of its neighbours.
  Eigen::Vector3f ray_in_cam(int u, int v, const std::array<float, 2>& offset) const;

  // Whether two triangles (-1 for none) show the same texture.
  bool is_one_surface(int triangle1, int triangle2) const {
    const auto& materials = tracer.scene().material_of_triangle;
    return triangle1 == triangle2 ||
           (triangle1 >= 0 && triangle2 >= 0 && materials[triangle1] == materials[triangle2]);
  }
};

// z of the plane of a triangle in the centre of a pixel, in double precision. Faster where pixels that follow
// each other see the same triangle; each thread has its own.
class ExactDepth {
 public:
  explicit ExactDepth(const View& view) : view_(view) {}
  double operator()(cv::Point pixel, std::uint32_t triangle);

 private:
  const View& view_;
  std::uint32_t triangle_ = kNoHit;
  int row_ = -1;
  Eigen::Vector3d normal_in_cam_;
  double offset_ = 0;
};

// One pose, or one for each row.
View view_of(const RayTracer& tracer, const RgbdOptions& options, const PixelRays& rays_in_cam,
             std::span<const Pose> world_from_cam_of_row);

// Eight rays of pixels.
struct Packet {
  Rays8 rays;
  std::array<float, 8> x_in_cam, y_in_cam, z_in_cam;
  std::array<cv::Point, 8> pixels;

  // One of them, beside the centre of a pixel.
  void aim(int i, const View& view, cv::Point pixel, const std::array<float, 2>& offset);
  // All of them, at 4 x 2 pixels from one on; those not within a rectangle are switched off.
  void aim_at_block(const View& view, cv::Point first, const cv::Rect& within);

  Eigen::Vector3f ray_in_cam(int i) const { return {x_in_cam[i], y_in_cam[i], z_in_cam[i]}; }
  Eigen::Vector3f direction(int i) const {
    return {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]};
  }

 private:
  void aim_at_four(int first_ray, const View& view, cv::Point pixel);
};

// Linear light from where a ray hits, 1 for white, with textures filtered over this part of a pixel.
Color shade(const View& view, const Hit& hit, const Eigen::Vector3f& ray_in_cam,
            const Eigen::Vector3f& direction, float part_of_pixel);

// Calls work(tile) for rectangles that cover the image, on all threads of the caller's arena.
inline constexpr int kTile = 32;
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

// Calls work(hit, packet, i) for what the ray of each pixel of a tile hits. Packets are 4 x 2 pixels.
template <typename Function>
void trace_tile(const View& view, const cv::Rect& tile, Function work) {
  for (int v0 = tile.y; v0 < tile.y + tile.height; v0 += 2) {
    for (int u0 = tile.x; u0 < tile.x + tile.width; u0 += 4) {
      Packet packet;
      packet.aim_at_block(view, {u0, v0}, tile);
      Hits8 hits;
      view.tracer.intersect(packet.rays, true, hits);
      for (int i = 0; i < 8; ++i)
        if (hits.triangle[i] != kNoHit) work(hits[i], packet, i);
    }
  }
}

}  // namespace framewise
