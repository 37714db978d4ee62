// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/sensor_view.h"

#include <cmath>

namespace framewise {
namespace {

using Eigen::Vector3f;

// Display value of light 0 to 1, read from a table.
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

// Light of a lamp at the camera on a surface: full within the beam, next to nothing at twice its angle. What
// it lights has no shadow that the camera could see.
float headlight(const View& view, const Vector3f& ray_in_cam, float cosine, float distance) {
  constexpr float kBeam = 0.5f;  // tangent of the half angle
  const float beyond = (ray_in_cam.x() * ray_in_cam.x() + ray_in_cam.y() * ray_in_cam.y()) /
                       (kBeam * kBeam * ray_in_cam.z() * ray_in_cam.z());
  return static_cast<float>(view.options.headlamp) * cosine / (distance * distance * (1 + beyond * beyond));
}

}  // namespace

Vector3f View::ray_in_cam(int u, int v, const std::array<float, 2>& offset) const {
  if (offset[0] == 0 && offset[1] == 0) return ray_in_cam(u, v);
  const int u0 = std::max(u - 1, 0), u1 = std::min(u + 1, options.camera.width - 1);
  const int v0 = std::max(v - 1, 0), v1 = std::min(v + 1, options.camera.height - 1);
  Vector3f ray = ray_in_cam(u, v);
  if (u1 > u0) ray += offset[0] / static_cast<float>(u1 - u0) * (ray_in_cam(u1, v) - ray_in_cam(u0, v));
  if (v1 > v0) ray += offset[1] / static_cast<float>(v1 - v0) * (ray_in_cam(u, v1) - ray_in_cam(u, v0));
  return ray;
}

double View::exact_z(int u, int v, std::uint32_t triangle) const {
  const Pose& world_from_cam = rows[v].world_from_cam;
  const Eigen::Vector3d ray = ray_in_cam(u, v).cast<double>();
  return ray.z() * tracer.exact_t(triangle, world_from_cam.t, world_from_cam.R * ray);
}

View view_of(const RayTracer& tracer, const RgbdOptions& options, const std::vector<Vector3f>& rays_in_cam,
             std::span<const Pose> world_from_cam_of_row) {
  const int width = options.camera.width, height = options.camera.height;
  const Vector3f middle = rays_in_cam[(height / 2) * width + width / 2],
                 beside = rays_in_cam[(height / 2) * width + width / 2 - (width > 1)];
  View view{tracer, options, rays_in_cam, {}, (middle - beside).norm()};
  for (const Pose& pose : world_from_cam_of_row) view.rows.emplace_back(pose);
  if (view.rows.size() == 1) view.rows.resize(height, view.rows.front());
  return view;
}

void Packet::aim(int i, const View& view, cv::Point pixel, const std::array<float, 2>& offset) {
  const RowPose& row = view.rows[pixel.y];
  pixels[i] = pixel;
  rays_in_cam[i] = view.ray_in_cam(pixel.x, pixel.y, offset);
  directions[i] = row.turn * rays_in_cam[i];
  rays.set(i, row.origin, directions[i], 1e-3f, 1e4f);
}

Color shade(const View& view, const Hit& hit, const Vector3f& ray_in_cam, const Vector3f& direction,
            float part_of_pixel) {
  const SurfacePoint at = view.tracer.surface_point(hit);
  const float length = direction.norm();
  const float facing = std::abs(at.normal.dot(direction)) / length;
  // Between the short and the long side of the pixel's foot on the surface.
  const float footprint =
      part_of_pixel * hit.t * length * view.pixel_angle / std::sqrt(std::max(0.1f, facing));
  const Color reflectance = albedo(*at.material, at.u, at.v, footprint) * at.tint;
  Color seen = at.material->emission > 0 ? reflectance * at.material->emission : reflectance * at.light;
  if (view.options.headlamp > 0) seen += reflectance * headlight(view, ray_in_cam, facing, hit.t * length);
  return seen * static_cast<float>(view.options.exposure);
}

Color displayed(const Color& light) {
  static const DisplayCurve curve;
  return {curve(light.r), curve(light.g), curve(light.b)};
}

}  // namespace framewise
