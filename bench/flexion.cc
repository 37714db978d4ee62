// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flexion images against the definition written plainly: milliseconds of processor time of one thread, in
// turns (lower quartile and least), and the largest difference in levels of 65535.
//   bench_flexion [rounds]
#include "framewise/image/flexion.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "framewise/image/relief.h"

namespace {

using namespace framewise;

// A room's walls with a step, Kinect-like coarse depth and 5 % of holes.
cv::Mat room_depth(int width, int height) {
  cv::Mat depth(height, width, CV_32F);
  std::uint32_t state = 1;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      state = state * 1664525u + 1013904223u;
      const double x = 2.0 * u / width - 1, y = 2.0 * v / height - 1;
      const double z = std::min({4.0, 2.0 / (std::abs(x) + 0.2), 1.5 / (std::abs(y) + 0.1)}) -
                       (std::hypot(x - 0.1, y) < 0.4 ? 0.8 : 0.0);
      const bool hole = (state >> 8) % 1000 < 2 || (u / 40 + v / 40) % 20 == 0;
      depth.at<float>(v, u) = hole ? std::numeric_limits<float>::quiet_NaN()
                                   : static_cast<float>(std::round(z * 5000 + (state >> 20) % 16) / 5000);
    }
  return depth;
}

struct Point {
  double x, y, z;
};
Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point unit(const Point& a) {
  const double length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

// Back-projects every pixel, then takes the cross products of every neighbourhood.
cv::Mat plain_flexion(const cv::Mat& depth, const Camera& camera) {
  const int width = depth.cols, height = depth.rows;
  std::vector<Point> points(depth.total());
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const double z = std::isnan(depth.at<float>(v, u)) ? 0 : depth.at<float>(v, u);
      points[v * width + u] = {(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z};
    }
  cv::Mat image(depth.size(), CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  for (int v = 1; v < height - 1; ++v)
    for (int u = 1; u < width - 1; ++u) {
      const Point* p = &points[v * width + u];
      const Point d0 = unit(minus(p[width], p[-width])), d1 = unit(minus(p[1], p[-1]));
      const Point d2 = unit(minus(p[width - 1], p[1 - width])), d3 = unit(minus(p[width + 1], p[-width - 1]));
      const double f = std::abs(dot(cross(d0, d1), cross(d2, d3)));
      image.at<float>(v, u) = static_cast<float>(f > 1 ? 1 : f);
    }
  return image;
}

double largest_difference(const cv::Mat& a, const cv::Mat& b) {
  double most = 0;
  for (int v = 0; v < a.rows; ++v)
    for (int u = 0; u < a.cols; ++u) {
      const float x = a.at<float>(v, u), y = b.at<float>(v, u);
      if (std::isnan(x) != std::isnan(y)) return std::numeric_limits<double>::infinity();
      if (!std::isnan(x)) most = std::max(most, std::abs(double{x} - y));
    }
  return most * 65535;
}

struct Rival {
  std::string name;
  std::function<double()> call;
};

// Time this thread had a processor: what else runs takes its share of the clock, not of this.
double processor_ms() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void print_race(const std::vector<Rival>& rivals, std::size_t rounds) {
  std::vector<std::vector<double>> times(rivals.size());
  volatile double sink = 0;
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < rivals.size(); ++k) {
      const double begin = processor_ms();
      sink = sink + rivals[k].call();
      times[k].push_back(processor_ms() - begin);
    }
  for (auto& t : times) std::sort(t.begin(), t.end());
  const auto quartile = [](const std::vector<double>& t) { return t[t.size() / 4]; };
  for (std::size_t k = 0; k < rivals.size(); ++k)
    std::printf("  %-44s %8.3f %8.3f %8.1f\n", rivals[k].name.c_str(), quartile(times[k]), times[k].front(),
                quartile(times[0]) / quartile(times[k]));
}

void race(int width, int height, std::size_t rounds) {
  Camera camera{CameraModel::kPinhole, width, height, 0.82 * width, 0.82 * width, 0.5 * width, 0.5 * height};
  Camera lens = camera;
  lens.distortion = {0.1, -0.2, 0.001, 0.001, 0.05};
  Camera sphere;
  sphere.model = CameraModel::kEquirectangular;
  sphere.width = width;
  sphere.height = height;
  const DepthRays z(camera, DepthType::kZ), range(camera, DepthType::kRange), distorted(lens, DepthType::kZ),
      around(sphere, DepthType::kRange);
  const cv::Mat depth = room_depth(width, height);
  FlexionOptions published, normalised, smoothed;
  normalised.form = smoothed.form = FlexionForm::kNormalised;
  smoothed.smoothing_sigma_px = 5;
  smoothed.distance_px = 6;
  ReliefOptions normal;

  cv::Mat memory;  // as in a video: the last image's
  const auto flexion = [&](const DepthRays& rays, const FlexionOptions& options) {
    return [&rays, &options, &depth, &memory] {
      memory = flexion_image(depth, rays, options, memory);
      return double{memory.at<float>(9, 9)};
    };
  };
  const std::vector<Rival> rivals = {
      {"plain: back-projection, cross products",
       [&] { return double{plain_flexion(depth, camera).at<float>(9, 9)}; }},
      {"published, z", flexion(z, published)},
      {"published, range", flexion(range, published)},
      {"published, equirectangular", flexion(around, published)},
      {"published, distorted lens (table of rays)", flexion(distorted, published)},
      {"normalised, z", flexion(z, normalised)},
      {"normalised, 1/z smoothed sigma 5, n 6", flexion(z, smoothed)},
      {"normal's z, n 4", [&] { return double{normal_image(depth, z, normal).at<float>(9, 9)}; }},
  };
  std::printf("%d x %d%38s %8s %8s %8s\n", width, height, "", "ms", "least", "ratio");
  print_race(rivals, rounds);
  std::printf("  largest difference, published, z: %.3f of 65535\n\n",
              largest_difference(plain_flexion(depth, camera), flexion_image(depth, z, published)));
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t rounds = argc > 1 ? std::max(1ul, std::strtoul(argv[1], nullptr, 10)) : 40;
  race(640, 480, rounds);
  race(1920, 1080, rounds);
  return 0;
}
