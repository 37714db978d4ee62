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

#include "framewise/image/depth.h"

namespace framewise {
namespace {

using Eigen::Vector3f;

constexpr int kTile = 32;
// Neighbours that differ by more than this (of 255) are drawn with more rays: at the border of two surfaces,
// and within one, where the texture is filtered already.
constexpr int kContrastOfSurfaces = 12, kContrastOfTexture = 40;
// A grid of four samples turned so that no two share a row or column (pixels from the centre).
constexpr std::array<float, 2> kSamples[4] = {
    {-0.125f, -0.375f}, {0.375f, -0.125f}, {-0.375f, 0.125f}, {0.125f, 0.375f}};

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
  cv::Mat radiance;  // CV_32FC3, empty where it is not asked for
  cv::Mat depth;     // CV_32F, empty where it is not asked for
  cv::Mat distance;  // CV_32F, z however far and in single precision, empty where it is not asked for
};

// Where a row of pixels is when it looks.
struct RowPose {
  Pose world_from_cam;
  Eigen::Matrix3f turn;
  Vector3f origin;

  explicit RowPose(const Pose& pose)
      : world_from_cam(pose), turn(pose.R.cast<float>()), origin(pose.t.cast<float>()) {}
};

struct View {
  const RayTracer& tracer;
  const RgbdOptions& options;
  const std::vector<Vector3f>& rays_in_cam;
  std::vector<RowPose> rows;
  float pixel_angle;
  const DisplayCurve& display;
  std::array<float, 2> offset = {0, 0};  // of all rays from the centres of the pixels (pixels)

  Vector3f ray_in_cam(int u, int v) const { return rays_in_cam[v * options.camera.width + u]; }

  bool is_one_surface(int triangle1, int triangle2) const {
    const auto& materials = tracer.scene().material_of_triangle;
    return triangle1 == triangle2 ||
           (triangle1 >= 0 && triangle2 >= 0 && materials[triangle1] == materials[triangle2]);
  }

  // The ray beside a pixel's centre, from the rays of its neighbours.
  Vector3f ray_in_cam(int u, int v, const std::array<float, 2>& offset) const {
    if (offset[0] == 0 && offset[1] == 0) return ray_in_cam(u, v);
    const int u0 = std::max(u - 1, 0), u1 = std::min(u + 1, options.camera.width - 1);
    const int v0 = std::max(v - 1, 0), v1 = std::min(v + 1, options.camera.height - 1);
    Vector3f ray = ray_in_cam(u, v);
    if (u1 > u0) ray += offset[0] / static_cast<float>(u1 - u0) * (ray_in_cam(u1, v) - ray_in_cam(u0, v));
    if (v1 > v0) ray += offset[1] / static_cast<float>(v1 - v0) * (ray_in_cam(u, v1) - ray_in_cam(u, v0));
    return ray;
  }
};

// Light of a lamp at the camera on a surface: full within the beam, next to nothing at twice its angle. What
// it lights has no shadow that the camera could see.
float headlight(const View& view, const Vector3f& ray_in_cam, float cosine, float distance) {
  constexpr float kBeam = 0.5f;  // tangent of the half angle
  const float beyond = (ray_in_cam.x() * ray_in_cam.x() + ray_in_cam.y() * ray_in_cam.y()) /
                       (kBeam * kBeam * ray_in_cam.z() * ray_in_cam.z());
  return static_cast<float>(view.options.headlamp) * cosine / (distance * distance * (1 + beyond * beyond));
}

// Light from where a ray hits, 1 for white, with textures filtered over this part of a pixel.
Color shade(const View& view, const Hits8& hits, int i, const Vector3f& ray_in_cam, const Vector3f& direction,
            float part_of_pixel) {
  const SurfacePoint at = view.tracer.surface_point(hits.triangle[i], hits.weight1[i], hits.weight2[i]);
  const float length = direction.norm();
  const float slant = std::max(0.1f, std::abs(at.normal.dot(direction)) / length);
  // Between the short and the long side of the pixel's foot on the surface.
  const float footprint = part_of_pixel * hits.t[i] * length * view.pixel_angle / std::sqrt(slant);
  const Color reflectance = albedo(*at.material, at.u, at.v, footprint) * at.tint;
  Color seen = at.material->emission > 0 ? reflectance * at.material->emission : reflectance * at.light;
  if (view.options.headlamp > 0)
    seen += reflectance *
            headlight(view, ray_in_cam, std::abs(at.normal.dot(direction)) / length, hits.t[i] * length);
  return seen * static_cast<float>(view.options.exposure);
}

Color displayed(const View& view, const Color& light) {
  return {view.display(light.r), view.display(light.g), view.display(light.b)};
}

cv::Vec3b to_bytes(const Color& display) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(x + 0.5f); };
  return {byte(display.b), byte(display.g), byte(display.r)};
}

double exact_z(const View& view, int u, int v, std::uint32_t triangle) {
  const Pose& world_from_cam = view.rows[v].world_from_cam;
  const Eigen::Vector3d ray = view.ray_in_cam(u, v).cast<double>();
  return ray.z() * view.tracer.exact_t(triangle, world_from_cam.t, world_from_cam.R * ray);
}

// What one ray in each of 4 x 2 pixels meets; pixels outside the image meet nothing.
struct PacketHits {
  std::array<Vector3f, 8> rays_in_cam, directions;
  Hits8 hits;
};

PacketHits meet(const View& view, int u0, int v0) {
  const Camera& camera = view.options.camera;
  PacketHits packet;
  Rays8 rays;
  for (int i = 0; i < 8; ++i) {
    const int u = u0 + i % 4, v = v0 + i / 4;
    if (u < camera.width && v < camera.height) {
      packet.rays_in_cam[i] = view.ray_in_cam(u, v, view.offset);
      packet.directions[i] = view.rows[v].turn * packet.rays_in_cam[i];
      rays.set(i, view.rows[v].origin, packet.directions[i], 1e-3f, 1e4f);
    } else {
      rays.switch_off(i);
    }
  }
  view.tracer.intersect(rays, true, packet.hits);
  return packet;
}

// First pass: one ray through the centre of each pixel gives depth and a colour. Rays go in packets of 4 x 2
// pixels.
void trace_centres(const View& view, int u0, int v0, Centres& centres) {
  cv::Mat& color = centres.color;
  const PacketHits packet = meet(view, u0, v0);
  const Hits8& hits = packet.hits;
  for (int i = 0; i < 8; ++i) {
    if (hits.triangle[i] == kNoHit) continue;
    const int u = u0 + i % 4, v = v0 + i / 4;
    const Color light = shade(view, hits, i, packet.rays_in_cam[i], packet.directions[i], 1);
    color.at<cv::Vec3b>(v, u) = to_bytes(displayed(view, light));
    if (!centres.radiance.empty()) centres.radiance.at<cv::Vec3f>(v, u) = {light.b, light.g, light.r};
    centres.triangle.at<int>(v, u) = static_cast<int>(hits.triangle[i]);
    if (!centres.distance.empty()) centres.distance.at<float>(v, u) = hits.t[i] * packet.rays_in_cam[i].z();
    if (centres.depth.empty()) continue;
    const double z = exact_z(view, u, v, hits.triangle[i]);
    if (z <= view.options.max_depth) centres.depth.at<float>(v, u) = static_cast<float>(z);
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
void trace_edges(const View& view, const std::array<cv::Point, 2>& pixels, int count, cv::Mat& color,
                 cv::Mat& radiance) {
  Rays8 rays;
  std::array<Vector3f, 8> rays_in_cam, directions;
  for (int i = 0; i < 8; ++i) {
    if (i / 4 < count) {
      const RowPose& row = view.rows[pixels[i / 4].y];
      rays_in_cam[i] = view.ray_in_cam(pixels[i / 4].x, pixels[i / 4].y, kSamples[i % 4]);
      directions[i] = row.turn * rays_in_cam[i];
      rays.set(i, row.origin, directions[i], 1e-3f, 1e4f);
    } else {
      rays.switch_off(i);
    }
  }
  Hits8 hits;
  view.tracer.intersect(rays, true, hits);
  for (int pixel = 0; pixel < count; ++pixel) {
    Color sum, light;
    for (int i = 4 * pixel; i < 4 * pixel + 4; ++i) {
      if (hits.triangle[i] == kNoHit) continue;
      const Color sample = shade(view, hits, i, rays_in_cam[i], directions[i], 0.6f);
      sum += displayed(view, sample);
      light += sample * 0.25f;
    }
    color.at<cv::Vec3b>(pixels[pixel].y, pixels[pixel].x) = to_bytes(sum * 0.25f);
    if (!radiance.empty())
      radiance.at<cv::Vec3f>(pixels[pixel].y, pixels[pixel].x) = {light.b, light.g, light.r};
  }
}

void refine_tile(const View& view, const cv::Rect& tile, const Centres& centres, cv::Mat& color,
                 cv::Mat& radiance) {
  std::array<cv::Point, 2> waiting;
  int count = 0;
  for (int v = tile.y; v < tile.y + tile.height; ++v) {
    for (int u = tile.x; u < tile.x + tile.width; ++u) {
      if (!needs_more_rays(view, centres, u, v)) continue;
      waiting[count++] = {u, v};
      if (count < 2) continue;
      trace_edges(view, waiting, count, color, radiance);
      count = 0;
    }
  }
  if (count > 0) trace_edges(view, waiting, count, color, radiance);
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
  if (!(exposure > 0 && std::isfinite(exposure)))
    throw std::invalid_argument("exposure is " + std::to_string(exposure) + ", expected a positive number");
  if (!(headlamp >= 0 && std::isfinite(headlamp)))
    throw std::invalid_argument("headlamp is " + std::to_string(headlamp) +
                                ", expected 0 or a positive number");
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
      if (options_.camera.model != CameraModel::kPinhole) continue;
      straight_rays_.push_back({static_cast<float>((u - options_.camera.cx) / options_.camera.fx),
                                static_cast<float>((v - options_.camera.cy) / options_.camera.fy), 1.0f});
    }
  }
}

namespace {

View view_of(const RayTracer& tracer, const RgbdOptions& options, const std::vector<Vector3f>& rays_in_cam,
             std::span<const Pose> world_from_cam_of_row) {
  static const DisplayCurve display;
  const int width = options.camera.width, height = options.camera.height;
  const Vector3f middle = rays_in_cam[(height / 2) * width + width / 2],
                 beside = rays_in_cam[(height / 2) * width + width / 2 - (width > 1)];
  View view{tracer, options, rays_in_cam, {}, (middle - beside).norm(), display};
  for (const Pose& pose : world_from_cam_of_row) view.rows.emplace_back(pose);
  if (view.rows.size() == 1) view.rows.resize(height, view.rows.front());
  return view;
}

Centres trace_all(const View& view, bool with_radiance, bool with_depth) {
  const int width = view.options.camera.width, height = view.options.camera.height;
  Centres centres{cv::Mat(height, width, CV_8UC3, cv::Scalar::all(0)),
                  cv::Mat(height, width, CV_32S, cv::Scalar(-1)),
                  {},
                  {},
                  {}};
  if (with_radiance) {
    centres.radiance = cv::Mat(height, width, CV_32FC3, cv::Scalar::all(0));
    centres.distance = cv::Mat(height, width, CV_32F, cv::Scalar(0));
  }
  if (with_depth) centres.depth = cv::Mat(height, width, CV_32F, cv::Scalar(kUnknownDepth));
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    for (int v = tile.y; v < tile.y + tile.height; v += 2)
      for (int u = tile.x; u < tile.x + tile.width; u += 4) trace_centres(view, u, v, centres);
  });
  return centres;
}

void refine_all(const View& view, const Centres& centres, cv::Mat& color, cv::Mat& radiance) {
  if (view.options.edge_samples == 4)
    for_each_tile(color.cols, color.rows,
                  [&](const cv::Rect& tile) { refine_tile(view, tile, centres, color, radiance); });
}

// What an undistorted camera sees in the middle of an exposure.
struct Middle {
  const View& view;
  Centres centres;

  // The light it sees at a place on a triangle, if it sees that place.
  const cv::Vec3f* light_at(const Vector3f& place, std::uint32_t triangle) const {
    const RowPose& pose = view.rows.front();
    const Camera& camera = view.options.camera;
    const Vector3f x = pose.turn.transpose() * (place - pose.origin);
    if (camera.model != CameraModel::kPinhole || x.z() < 1e-3f) return nullptr;
    const float u = static_cast<float>(camera.fx) * x.x() / x.z() + static_cast<float>(camera.cx) + 0.5f,
                v = static_cast<float>(camera.fy) * x.y() / x.z() + static_cast<float>(camera.cy) + 0.5f;
    if (!(u >= 0 && v >= 0 && u < static_cast<float>(camera.width) && v < static_cast<float>(camera.height)))
      return nullptr;
    const int column = static_cast<int>(u), row = static_cast<int>(v);
    constexpr float kNear = 0.02f;  // share of the distance within which it is the same place
    if (!view.is_one_surface(centres.triangle.at<int>(row, column), static_cast<int>(triangle)) ||
        std::abs(centres.distance.at<float>(row, column) - x.z()) > kNear * x.z())
      return nullptr;
    return &centres.radiance.at<cv::Vec3f>(row, column);
  }
};

// The light of one ray in each of 4 x 2 pixels.
void add_light(const View& view, const Middle& middle, int u0, int v0, cv::Mat& sum) {
  const PacketHits packet = meet(view, u0, v0);
  const Hits8& hits = packet.hits;
  for (int i = 0; i < 8; ++i) {
    if (hits.triangle[i] == kNoHit) continue;
    const int u = u0 + i % 4, v = v0 + i / 4;
    const Vector3f place = view.rows[v].origin + hits.t[i] * packet.directions[i];
    cv::Vec3f& light = sum.at<cv::Vec3f>(v, u);
    if (const cv::Vec3f* known = middle.light_at(place, hits.triangle[i])) {
      light += *known;
    } else {
      const Color shaded = shade(view, hits, i, packet.rays_in_cam[i], packet.directions[i], 1);
      light += cv::Vec3f(shaded.b, shaded.g, shaded.r);
    }
  }
}

// Depth and slant alone, for 4 x 2 pixels.
void trace_surface(const View& view, int u0, int v0, SurfaceImage& surface) {
  const PacketHits packet = meet(view, u0, v0);
  const Hits8& hits = packet.hits;
  for (int i = 0; i < 8; ++i) {
    if (hits.triangle[i] == kNoHit) continue;
    const int u = u0 + i % 4, v = v0 + i / 4;
    const SurfacePoint at = view.tracer.surface_point(hits.triangle[i], hits.weight1[i], hits.weight2[i]);
    surface.depth.at<float>(v, u) = static_cast<float>(exact_z(view, u, v, hits.triangle[i]));
    surface.facing.at<float>(v, u) =
        std::abs(at.normal.dot(packet.directions[i])) / packet.directions[i].norm();
  }
}

}  // namespace

Frame RgbdSensor::render(const RayTracer& tracer, const Pose& world_from_cam) const {
  const View view = view_of(tracer, options_, rays_in_cam_, {&world_from_cam, 1});
  const Centres centres = trace_all(view, false, true);
  Frame frame;
  frame.depth = centres.depth;
  frame.color = centres.color.clone();
  cv::Mat no_radiance;
  refine_all(view, centres, frame.color, no_radiance);
  cv::cvtColor(frame.color, frame.gray, cv::COLOR_BGR2GRAY);
  return frame;
}

cv::Mat RgbdSensor::light(const RayTracer& tracer, std::span<const Pose> world_from_cam_of_row) const {
  const View view = view_of(tracer, options_, rays_in_cam_, world_from_cam_of_row);
  const Centres centres = trace_all(view, true, false);
  cv::Mat color = centres.color.clone(), radiance = centres.radiance.clone();
  refine_all(view, centres, color, radiance);
  return radiance;
}

cv::Mat RgbdSensor::mean_light(const RayTracer& tracer, const Pose& world_from_cam_in_the_middle,
                               std::span<const Instant> instants) const {
  const int width = options_.camera.width, height = options_.camera.height;
  const auto& rays = straight_rays_.empty() ? rays_in_cam_ : straight_rays_;
  const View middle = view_of(tracer, options_, rays, {&world_from_cam_in_the_middle, 1});
  const Middle seen{middle, trace_all(middle, true, false)};
  std::vector<View> views;
  for (const Instant& instant : instants) {
    views.push_back(view_of(tracer, options_, rays_in_cam_, instant.world_from_cam_of_row));
    views.back().offset = instant.offset;
  }
  cv::Mat sum(height, width, CV_32FC3, cv::Scalar::all(0));
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    for (const View& view : views)
      for (int v = tile.y; v < tile.y + tile.height; v += 2)
        for (int u = tile.x; u < tile.x + tile.width; u += 4) add_light(view, seen, u, v, sum);
  });
  return sum * (1.0 / static_cast<double>(instants.size()));
}

SurfaceImage RgbdSensor::surface(const RayTracer& tracer, const Pose& world_from_cam) const {
  const int width = options_.camera.width, height = options_.camera.height;
  const View view = view_of(tracer, options_, rays_in_cam_, {&world_from_cam, 1});
  SurfaceImage surface{cv::Mat(height, width, CV_32F, cv::Scalar(kUnknownDepth)),
                       cv::Mat(height, width, CV_32F, cv::Scalar(0))};
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    for (int v = tile.y; v < tile.y + tile.height; v += 2)
      for (int u = tile.x; u < tile.x + tile.width; u += 4) trace_surface(view, u, v, surface);
  });
  return surface;
}

}  // namespace framewise
