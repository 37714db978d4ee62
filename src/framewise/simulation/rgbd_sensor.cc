// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/rgbd_sensor.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "framewise/image/depth.h"
#include "framewise/simulation/blur.h"
#include "framewise/simulation/color_pass.h"
#include "framewise/simulation/edge_pass.h"

namespace framewise {

void RgbdOptions::check() const {
  camera.check();
  if (!(max_depth > 0))
    throw std::invalid_argument("max_depth is " + std::to_string(max_depth) +
                                ", expected a positive number of metres");
  if (edge_samples != 1 && edge_samples != 4)
    throw std::invalid_argument("edge_samples is " + std::to_string(edge_samples) + ", expected 1 or 4");
  if (!(exposure > 0 && std::isfinite(exposure)))
    throw std::invalid_argument("exposure is " + std::to_string(exposure) + ", expected a positive number");
  if (!(headlamp >= 0 && std::isfinite(headlamp)))
    throw std::invalid_argument("headlamp is " + std::to_string(headlamp) +
                                ", expected 0 or a positive number");
}

RgbdSensor::RgbdSensor(const RgbdOptions& options) : options_(options) {
  options_.check();
  rays_in_cam_.width = straight_rays_.width = options_.camera.width;
  rays_in_cam_.height = straight_rays_.height = options_.camera.height;
  for (int v = 0; v < options_.camera.height; ++v) {
    for (int u = 0; u < options_.camera.width; ++u) {
      const auto x = options_.camera.bearing({u, v});
      if (!x)
        throw std::invalid_argument("camera: no ray for pixel " + std::to_string(u) + " " +
                                    std::to_string(v) + ", expected one for each");
      const Bearing ray = x->z() > 0.01 ? Bearing(*x / x->z()) : *x;
      rays_in_cam_.push_back(ray.cast<float>());
      if (options_.camera.model != CameraModel::kPinhole) continue;
      straight_rays_.push_back({static_cast<float>((u - options_.camera.cx) / options_.camera.fx),
                                static_cast<float>((v - options_.camera.cy) / options_.camera.fy), 1.0f});
    }
  }
}

Frame RgbdSensor::render(const RayTracer& tracer, const Pose& world_from_cam) const {
  const View view = view_of(tracer, options_, rays_in_cam_, {&world_from_cam, 1});
  const Centres centres = trace_centres(view, false, true);
  Frame frame;
  frame.depth = centres.depth;
  frame.color = with_smooth_edges(view, centres, centres.color);
  cv::cvtColor(frame.color, frame.gray, cv::COLOR_BGR2GRAY);
  return frame;
}

cv::Mat RgbdSensor::light(const RayTracer& tracer, std::span<const Pose> world_from_cam_of_row) const {
  const View view = view_of(tracer, options_, rays_in_cam_, world_from_cam_of_row);
  const Centres centres = trace_centres(view, true, false);
  return with_smooth_edges(view, centres, centres.radiance);
}

cv::Mat RgbdSensor::mean_light(const RayTracer& tracer, const Pose& world_from_cam_in_the_middle,
                               std::span<const Instant> instants) const {
  const auto& rays = straight_rays_.x.empty() ? rays_in_cam_ : straight_rays_;
  std::vector<View> views;
  for (const Instant& instant : instants) {
    views.push_back(view_of(tracer, options_, rays_in_cam_, instant.world_from_cam_of_row));
    views.back().offset = instant.offset;
  }
  return mean_of_views(view_of(tracer, options_, rays, {&world_from_cam_in_the_middle, 1}), views);
}

SurfaceImage RgbdSensor::surface(const RayTracer& tracer, const Pose& world_from_cam) const {
  const int width = options_.camera.width, height = options_.camera.height;
  const View view = view_of(tracer, options_, rays_in_cam_, {&world_from_cam, 1});
  SurfaceImage surface{cv::Mat(height, width, CV_32F, cv::Scalar(kUnknownDepth)),
                       cv::Mat(height, width, CV_32F, cv::Scalar(0))};
  const auto keep = [&](ExactDepth& exact_z, const Hit& hit, const Packet& packet, int i) {
    const cv::Point pixel = packet.pixels[i];
    const Eigen::Vector3f normal = tracer.surface_point(hit).normal, direction = packet.direction(i);
    surface.depth.at<float>(pixel) = static_cast<float>(exact_z(pixel, hit.triangle));
    surface.facing.at<float>(pixel) = std::abs(normal.dot(direction)) / direction.norm();
  };
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    ExactDepth exact_z(view);
    trace_tile(view, tile,
               [&](const Hit& hit, const Packet& packet, int i) { keep(exact_z, hit, packet, i); });
  });
  return surface;
}

}  // namespace framewise
