// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/surface_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"
#include "framewise/image/inverse_depth_smoothing.h"

namespace framewise {
namespace {

// What the loops need to know of the rays, for each kind of camera.
class RowMeasure {
 public:
  RowMeasure(const DepthRays& rays, const SurfacePass& pass) : rays_(rays), pass_(pass) {
    const Camera& camera = rays.camera;
    // A table of an image that is upside down to the camera's axes turns d0 x d1 round.
    const bool turned = rays.kind == DepthRays::Kind::kTable && camera.fy < 0;
    const Eigen::Vector3f light = (turned ? -pass.light : pass.light).cast<float>();
    light_ = {light.x(), light.y(), light.z()};
    columns_.resize(camera.width);
    if (rays.kind == DepthRays::Kind::kPlane)
      for (int u = 0; u < camera.width; ++u)
        columns_[u] = static_cast<float>((u - camera.cx) / pass.distance_px);
    if (rays.kind == DepthRays::Kind::kSphere) lights_of_columns();
  }

  void operator()(const DepthRows& rows, int v, float* out) const {
    switch (rays_.kind) {
      case DepthRays::Kind::kPlane:
        return measure_plane_row(rows, plane_rays(v), pass_.measure, light_, out);
      case DepthRays::Kind::kSphere:
        return measure_sphere_row(rows, sphere_rays(v), pass_.measure, out);
      case DepthRays::Kind::kTable:
        return measure_table_row(rows, table_rays(v - pass_.distance_px), table_rays(v),
                                 table_rays(v + pass_.distance_px), pass_.measure, light_, out);
    }
  }

 private:
  // The light as each column sees it, from axes turned to its azimuth.
  void lights_of_columns() {
    const int width = rays_.camera.width;
    light_z_.resize(width);
    for (int u = 0; u < width; ++u) {
      const double azimuth = (u + 0.5 - 0.5 * width) * 2 * M_PI / width;
      columns_[u] =
          static_cast<float>(std::cos(azimuth) * pass_.light.x() - std::sin(azimuth) * pass_.light.z());
      light_z_[u] =
          static_cast<float>(std::sin(azimuth) * pass_.light.x() + std::cos(azimuth) * pass_.light.z());
    }
  }

  PlaneRays plane_rays(int v) const {
    const Camera& camera = rays_.camera;
    return {columns_.data(), (v - camera.cy) / camera.fy, pass_.distance_px / camera.fx,
            pass_.distance_px / camera.fy};
  }

  SphereRays sphere_rays(int v) const {
    const Camera& camera = rays_.camera;
    const double step = (camera.theta_range[1] - camera.theta_range[0]) / camera.height;
    const auto theta = [&](int row) { return camera.theta_range[0] + (row + 0.5) * step; };
    const int n = pass_.distance_px;
    return {theta(v - n),          theta(v),        theta(v + n), 2 * M_PI / camera.width * n,
            pass_.light_along_ray, columns_.data(), light_.y,     light_z_.data()};
  }

  TableRays table_rays(int v) const {
    return {rays_.x.ptr<double>(v), rays_.y.ptr<double>(v), rays_.z.ptr<double>(v)};
  }

  const DepthRays& rays_;
  const SurfacePass& pass_;
  Direction light_;
  std::vector<float> columns_;  // kPlane: X; kSphere: the light's x
  std::vector<float> light_z_;
};

// The depths of one row after another, cleaned, brought to what the rays are for, and smoothed.
class DepthRowSource {
 public:
  DepthRowSource(const cv::Mat& depth, const DepthRays& rays, const SurfacePass& pass)
      : depth_(depth),
        rays_(rays),
        unknown_(pass.unknown_at_camera ? 0.0f : kUnknownDepth),
        cleaned_(depth.cols) {
    if (pass.smoothing_sigma_px > 0) smoothing_.emplace(depth.cols, pass.smoothing_sigma_px);
  }

  // Whether what comes is inverse depth.
  bool inverse() const { return smoothing_ && rays_.kind != DepthRays::Kind::kTable; }

  void next(float* out) {
    if (!smoothing_) return clean(out);
    do {
      const bool more = taken_ < depth_.rows;
      smoothing_->push(more ? next_depths() : nullptr, out);
      ++pushed_;
    } while (pushed_ <= smoothing_->latency());
    if (!inverse())
      for (int u = 0; u < depth_.cols; ++u) out[u] = 1 / out[u];
  }

 private:
  const float* scale(int v) const {
    return rays_.z_per_range.empty() ? nullptr : rays_.z_per_range.ptr<float>(v);
  }

  void clean(float* out) {
    clean_depths(depth_.ptr<float>(taken_), scale(taken_), depth_.cols, unknown_, out);
    ++taken_;
  }

  // The smoothing knows itself what is no depth.
  const float* next_depths() {
    if (!scale(taken_)) return depth_.ptr<float>(taken_++);
    clean(cleaned_.data());
    return cleaned_.data();
  }

  const cv::Mat& depth_;
  const DepthRays& rays_;
  float unknown_;
  std::vector<float> cleaned_;
  std::optional<InverseDepthSmoothing> smoothing_;
  int taken_ = 0, pushed_ = 0;
};

}  // namespace

void check_surface_options(int distance_px, double smoothing_sigma_px) {
  if (distance_px < 1)
    throw std::invalid_argument("distance_px: found " + std::to_string(distance_px) +
                                ", expected at least 1");
  if (smoothing_sigma_px != 0) gaussian_boxes(smoothing_sigma_px);
}

cv::Mat measure_surface(const cv::Mat& depth, const DepthRays& rays, const SurfacePass& pass, cv::Mat image) {
  check_image("depth", depth, CV_32F);
  check_image_size("depth", depth, rays.camera.width, rays.camera.height);
  const int n = pass.distance_px, width = depth.cols, height = depth.rows;
  if (image.datastart == depth.datastart) image.release();  // rows are read after others are written
  image.create(depth.size(), CV_32F);
  if (width <= 2 * n || height <= 2 * n) return image.setTo(kUnknownDepth);

  const RowMeasure measure(rays, pass);
  DepthRowSource source(depth, rays, pass);
  std::vector<std::vector<float>> ring(2 * n + 1, std::vector<float>(width));
  const auto row = [&](int v) { return ring[v % (2 * n + 1)].data(); };
  for (int v = 0; v < 2 * n; ++v) source.next(row(v));
  image.rowRange(0, n).setTo(kUnknownDepth);
  image.rowRange(height - n, height).setTo(kUnknownDepth);
  for (int v = n; v < height - n; ++v) {
    source.next(row(v + n));
    float* out = image.ptr<float>(v);
    measure({row(v - n), row(v), row(v + n), width, n, source.inverse()}, v, out);
    std::fill_n(out, n, kUnknownDepth);
    std::fill_n(out + width - n, n, kUnknownDepth);
  }
  return image;
}

}  // namespace framewise
