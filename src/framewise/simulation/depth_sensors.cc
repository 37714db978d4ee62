// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/depth_sensors.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "framewise/image/depth.h"
#include "framewise/simulation/random.h"

namespace framewise {
namespace {

// Each row has random numbers of its own, so that rows can be done in any order.
template <typename Function>
cv::Mat row_by_row(const cv::Mat& depth, std::uint64_t seed, Function row) {
  cv::Mat measured(depth.size(), CV_32F, cv::Scalar(kUnknownDepth));
  tbb::parallel_for(0, depth.rows, [&](int v) {
    Random random(Random(seed + static_cast<std::uint64_t>(v)).bits());
    row(v, random, measured.ptr<float>(v));
  });
  return measured;
}

// The neighbour (of four) that is farthest away from this pixel's depth.
float other_side(const cv::Mat& depth, int u, int v) {
  const float here = depth.at<float>(v, u);
  float other = here;
  for (const auto& step : {cv::Point(-1, 0), cv::Point(1, 0), cv::Point(0, -1), cv::Point(0, 1)}) {
    const float z =
        depth.at<float>(std::clamp(v + step.y, 0, depth.rows - 1), std::clamp(u + step.x, 0, depth.cols - 1));
    if (is_known_depth(z) && std::abs(z - here) > std::abs(other - here)) other = z;
  }
  return other;
}

bool is_edge(const cv::Mat& depth, int u, int v, double edge) {
  const float here = depth.at<float>(v, u);
  return std::abs(other_side(depth, u, v) - here) > edge * here;
}

// Whether the projector lights each pixel of a row: seen from it, at column u - disparity, no pixel further
// on lies before this one.
std::vector<bool> lit_by_projector(const float* depth, int width, double focal_times_baseline) {
  std::vector<bool> lit(width);
  double nearest = std::numeric_limits<double>::infinity();
  for (int u = width - 1; u >= 0; --u) {
    if (!is_known_depth(depth[u])) continue;
    const double column = u - focal_times_baseline / depth[u];
    lit[u] = column < nearest;
    nearest = std::min(nearest, column);
  }
  return lit;
}

double on_lattice(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }

// z / range of each pixel, 0 where a pixel has no ray.
cv::Mat z_per_range(const Camera& camera) {
  cv::Mat factor(camera.height, camera.width, CV_32F, cv::Scalar(0));
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u)
      if (const auto ray = camera.bearing({u, v})) factor.at<float>(v, u) = static_cast<float>(ray->z());
  return factor;
}

// Which pixels a shot of the LiDAR falls into.
cv::Mat lidar_pixels(const Camera& camera, const LidarOptions& options) {
  cv::Mat shot(camera.height, camera.width, CV_8U, cv::Scalar(0));
  constexpr double kDegrees = M_PI / 180;
  const int steps = static_cast<int>(90 / options.azimuth_step_deg);
  for (int beam = 0; beam < options.beams; ++beam) {
    const double share = options.beams > 1 ? static_cast<double>(beam) / (options.beams - 1) : 0;
    const double up = (options.lowest_deg + share * (options.highest_deg - options.lowest_deg)) * kDegrees;
    for (int k = -steps; k <= steps; ++k) {
      const double azimuth = k * options.azimuth_step_deg * kDegrees;
      const auto pixel =
          camera.project({std::sin(azimuth) * std::cos(up), -std::sin(up), std::cos(azimuth) * std::cos(up)});
      if (pixel && camera.contains(*pixel))
        shot.at<std::uint8_t>(static_cast<int>(std::floor(pixel->y() + 0.5)),
                              static_cast<int>(std::floor(pixel->x() + 0.5))) = 1;
    }
  }
  return shot;
}

DepthSensorOptions with_noise_scaled(DepthSensorOptions options) {
  options.check();
  options.kinect.noise.floor *= options.noise;
  options.kinect.noise.growth *= options.noise;
  options.kinect.step_px *= options.noise;
  options.time_of_flight.sigma_1m *= options.noise;
  if (options.noise == 0) options.time_of_flight.edge = std::numeric_limits<double>::infinity();
  options.lidar.sigma *= options.noise;
  return options;
}

}  // namespace

cv::Mat kinect_depth(const SurfaceImage& surface, const Camera& camera, const KinectOptions& options,
                     std::uint64_t seed) {
  const cv::Mat& truth = surface.depth;
  const double to_disparity = options.focal_px * options.baseline;
  return row_by_row(truth, seed, [&](int v, Random& random, float* measured) {
    const auto lit = lit_by_projector(truth.ptr<float>(v), truth.cols, camera.fx * options.baseline);
    for (int u = 0; u < truth.cols; ++u) {
      const double noise = random.normal(), z = truth.at<float>(v, u);
      if (!lit[u] || z < options.nearest || surface.facing.at<float>(v, u) < options.grazing ||
          is_edge(truth, u, v, options.edge))
        continue;
      const double noisy = z + options.noise.sigma(z) * noise;
      const double disparity = on_lattice(to_disparity / noisy, options.step_px);
      if (noisy > 0 && disparity > 0) measured[u] = static_cast<float>(to_disparity / disparity);
    }
  });
}

cv::Mat time_of_flight_depth(const SurfaceImage& surface, const Camera& camera,
                             const TimeOfFlightOptions& options, std::uint64_t seed) {
  const cv::Mat& truth = surface.depth;
  const cv::Mat factor = z_per_range(camera);
  return row_by_row(truth, seed, [&](int v, Random& random, float* measured) {
    for (int u = 0; u < truth.cols; ++u) {
      const double noise = random.normal(), mixture = random.uniform(0, 1);
      double z = truth.at<float>(v, u);
      const double z_of_range = factor.at<float>(v, u), cosine = surface.facing.at<float>(v, u);
      if (!(z > 0) || !(z_of_range > 0)) continue;
      if (is_edge(truth, u, v, options.edge)) z += 0.5 * mixture * (other_side(truth, u, v) - z);
      const double range = z / z_of_range;
      if (cosine / (range * range) < options.darkest) continue;
      const double noisy = range + options.sigma_1m * range * range / cosine * noise;
      const double wrapped = std::fmod(noisy, options.ambiguity);
      if (wrapped > 0) measured[u] = static_cast<float>(wrapped * z_of_range);
    }
  });
}

cv::Mat lidar_depth(const SurfaceImage& surface, const Camera& camera, const LidarOptions& options,
                    std::uint64_t seed) {
  const cv::Mat& truth = surface.depth;
  const cv::Mat factor = z_per_range(camera), shot = lidar_pixels(camera, options);
  return row_by_row(truth, seed, [&](int v, Random& random, float* measured) {
    for (int u = 0; u < truth.cols; ++u) {
      const double noise = options.sigma * random.normal(), z = truth.at<float>(v, u);
      if (!shot.at<std::uint8_t>(v, u) || !(z > 0) || surface.facing.at<float>(v, u) < options.grazing)
        continue;
      const double noisy = z + noise * factor.at<float>(v, u);
      if (noisy > 0) measured[u] = static_cast<float>(noisy);
    }
  });
}

const std::vector<std::string>& depth_sensor_names() {
  static const std::vector<std::string> names{"exact", "kinect", "tof", "lidar"};
  return names;
}

DepthSensor depth_sensor_from_name(const std::string& name) {
  const auto& names = depth_sensor_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<DepthSensor>(found - names.begin());
  throw std::invalid_argument("depth sensor is '" + name + "', expected exact, kinect, tof or lidar");
}

double usual_reach(DepthSensor sensor) {
  switch (sensor) {
    case DepthSensor::kExact:
      return 10;
    case DepthSensor::kKinect:
      return 8;
    case DepthSensor::kTimeOfFlight:
      return 13;
    case DepthSensor::kLidar:
      return 120;
  }
  return 10;
}

void DepthSensorOptions::check() const {
  if (!(noise >= 0 && noise <= 100))
    throw std::invalid_argument("depth noise is " + std::to_string(noise) +
                                ", expected 0 (none) to 100 times the sensor's usual");
}

cv::Mat measure_depth(const SurfaceImage& surface, const Camera& camera, const DepthSensorOptions& usual,
                      std::uint64_t seed) {
  const DepthSensorOptions options = with_noise_scaled(usual);
  switch (options.sensor) {
    case DepthSensor::kExact:
      break;
    case DepthSensor::kKinect:
      return kinect_depth(surface, camera, options.kinect, seed);
    case DepthSensor::kTimeOfFlight:
      return time_of_flight_depth(surface, camera, options.time_of_flight, seed);
    case DepthSensor::kLidar:
      return lidar_depth(surface, camera, options.lidar, seed);
  }
  return surface.depth.clone();
}

}  // namespace framewise
