// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/sensor_view.h"

#include <cmath>

namespace framewise {
namespace {

using Eigen::Vector3f;

constexpr float kNear = 1e-3f, kFar = 1e4f;  // how far rays reach (m)

// Light of a lamp at the camera on a surface: full within the beam, next to nothing at twice its angle. What
// it lights has no shadow that the camera could see.
float headlight(const View& view, const Vector3f& ray_in_cam, float cosine, float distance) {
  constexpr float kBeam = 0.5f;  // tangent of the half angle
  const float beyond = (ray_in_cam.x() * ray_in_cam.x() + ray_in_cam.y() * ray_in_cam.y()) /
                       (kBeam * kBeam * ray_in_cam.z() * ray_in_cam.z());
  return static_cast<float>(view.options.headlamp) * cosine / (distance * distance * (1 + beyond * beyond));
}

}  // namespace

DisplayCurve::DisplayCurve() {
  for (int i = 0; i < kSize; ++i) {
    const double c = (i + 0.5) / kSize;
    table_[i] = static_cast<float>(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055));
  }
}

Vector3f View::ray_in_cam(int u, int v, const std::array<float, 2>& offset) const {
  if (offset[0] == 0 && offset[1] == 0) return rays_in_cam(u, v);
  const int u0 = std::max(u - 1, 0), u1 = std::min(u + 1, options.camera.width - 1);
  const int v0 = std::max(v - 1, 0), v1 = std::min(v + 1, options.camera.height - 1);
  Vector3f ray = rays_in_cam(u, v);
  if (u1 > u0) ray += offset[0] / static_cast<float>(u1 - u0) * (rays_in_cam(u1, v) - rays_in_cam(u0, v));
  if (v1 > v0) ray += offset[1] / static_cast<float>(v1 - v0) * (rays_in_cam(u, v1) - rays_in_cam(u, v0));
  return ray;
}

double ExactDepth::operator()(cv::Point pixel, std::uint32_t triangle) {
  if (triangle != triangle_ || (pixel.y != row_ && view_.rows_differ)) {
    const Pose& world_from_cam = view_.rows[pixel.y].world_from_cam;
    const auto& [normal, offset] = view_.tracer.plane(triangle);
    normal_in_cam_ = world_from_cam.R.transpose() * normal;
    offset_ = offset - normal.dot(world_from_cam.t);
    triangle_ = triangle;
    row_ = pixel.y;
  }
  const Eigen::Vector3d ray = view_.rays_in_cam(pixel.x, pixel.y).cast<double>();
  return ray.z() * offset_ / normal_in_cam_.dot(ray);
}

View view_of(const RayTracer& tracer, const RgbdOptions& options, const PixelRays& rays_in_cam,
             std::span<const Pose> world_from_cam_of_row) {
  const int width = options.camera.width, height = options.camera.height;
  const Vector3f middle = rays_in_cam(width / 2, height / 2),
                 beside = rays_in_cam(width / 2 - (width > 1), height / 2);
  View view{.tracer = tracer,
            .options = options,
            .rays_in_cam = rays_in_cam,
            .rows = {},
            .pixel_angle = (middle - beside).norm(),
            .rows_differ = world_from_cam_of_row.size() > 1};
  for (const Pose& pose : world_from_cam_of_row) view.rows.emplace_back(pose);
  if (view.rows.size() == 1) view.rows.resize(height, view.rows.front());
  return view;
}

void Packet::aim(int i, const View& view, cv::Point pixel, const std::array<float, 2>& offset) {
  const RowPose& row = view.rows[pixel.y];
  const Vector3f ray = view.ray_in_cam(pixel.x, pixel.y, offset);
  pixels[i] = pixel;
  x_in_cam[i] = ray.x();
  y_in_cam[i] = ray.y();
  z_in_cam[i] = ray.z();
  rays.set(i, row.origin, row.turn * ray, kNear, kFar);
}

// All within the image and, where rays have an offset, not at its border.
void Packet::aim_at_four(int first_ray, const View& view, cv::Point pixel) {
  const PixelRays& all = view.rays_in_cam;
  const std::size_t first = static_cast<std::size_t>(pixel.y) * all.width + pixel.x;
  std::array<float, 4> x, y, z;
  std::copy_n(all.x.data() + first, 4, x.data());
  std::copy_n(all.y.data() + first, 4, y.data());
  std::copy_n(all.z.data() + first, 4, z.data());
  if (view.offset[0] != 0 || view.offset[1] != 0) {
    const float du = 0.5f * view.offset[0], dv = 0.5f * view.offset[1];
    const auto shift = [&](std::array<float, 4>& to, const float* at) {
      for (int k = 0; k < 4; ++k)
        to[k] += du * (at[k + 1] - at[k - 1]) + dv * (at[k + all.width] - at[k - all.width]);
    };
    shift(x, all.x.data() + first);
    shift(y, all.y.data() + first);
    shift(z, all.z.data() + first);
  }
  const RowPose& row = view.rows[pixel.y];
  const Eigen::Matrix3f& R = row.turn;
  for (int k = 0; k < 4; ++k) {
    const int i = first_ray + k;
    x_in_cam[i] = x[k];
    y_in_cam[i] = y[k];
    z_in_cam[i] = z[k];
    rays.origin_x[i] = row.origin.x();
    rays.origin_y[i] = row.origin.y();
    rays.origin_z[i] = row.origin.z();
    rays.direction_x[i] = R(0, 0) * x[k] + R(0, 1) * y[k] + R(0, 2) * z[k];
    rays.direction_y[i] = R(1, 0) * x[k] + R(1, 1) * y[k] + R(1, 2) * z[k];
    rays.direction_z[i] = R(2, 0) * x[k] + R(2, 1) * y[k] + R(2, 2) * z[k];
    rays.near[i] = kNear;
    rays.far[i] = kFar;
    pixels[i] = {pixel.x + k, pixel.y};
  }
}

void Packet::aim_at_block(const View& view, cv::Point first, const cv::Rect& within) {
  const int border = view.offset[0] != 0 || view.offset[1] != 0 ? 1 : 0;
  const cv::Rect inner(border, border, view.rays_in_cam.width - 2 * border,
                       view.rays_in_cam.height - 2 * border);
  const cv::Rect block(first.x, first.y, 4, 2);
  if ((block & within & inner) == block) {
    aim_at_four(0, view, first);
    aim_at_four(4, view, {first.x, first.y + 1});
    return;
  }
  for (int i = 0; i < 8; ++i) {
    if (const cv::Point pixel(first.x + i % 4, first.y + i / 4); within.contains(pixel))
      aim(i, view, pixel, view.offset);
    else
      rays.switch_off(i);
  }
}

Color shade(const View& view, const Hit& hit, const Vector3f& ray_in_cam, const Vector3f& direction,
            float part_of_pixel) {
  const SurfacePoint at = view.tracer.surface_point(hit);
  const float length = direction.norm(), across = std::abs(at.normal.dot(direction));
  // Between the short and the long side of the pixel's foot on the surface.
  const float footprint =
      part_of_pixel * hit.t * length * view.pixel_angle * std::sqrt(length / std::max(0.1f * length, across));
  const Color reflectance = albedo(*at.material, at.u, at.v, footprint) * at.tint;
  Color seen = at.material->emission > 0 ? reflectance * at.material->emission : reflectance * at.light;
  if (view.options.headlamp > 0)
    seen += reflectance * headlight(view, ray_in_cam, across / length, hit.t * length);
  return seen * static_cast<float>(view.options.exposure);
}

const DisplayCurve& display_curve() {
  static const DisplayCurve curve;
  return curve;
}

}  // namespace framewise
