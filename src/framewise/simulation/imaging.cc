// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/imaging.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/simulation/random.h"

namespace framewise {
namespace {

void expect_imaging(bool right, const char* name, double found, const std::string& expected) {
  if (!right)
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(found) + ", expected " +
                                expected);
}

// Poses of the rows around a time, one alone where they are all the same.
std::vector<Pose> row_poses(const Path& path, double time, double readout_time, int rows) {
  if (readout_time == 0) return {path(time).world_from_cam};
  std::vector<Pose> poses;
  for (int v = 0; v < rows; ++v)
    poses.push_back(path(time + readout_time * ((v + 0.5) / rows - 0.5)).world_from_cam);
  return poses;
}

// Points spread over a pixel, k of them as evenly as any: Halton, On the efficiency of certain quasi-random
// sequences of points, 1960.
std::array<float, 2> offset_of_sample(int k, int count) {
  float radical_inverse = 0, digit = 0.5f;
  for (int rest = k; rest > 0; rest /= 2, digit *= 0.5f)
    radical_inverse += digit * static_cast<float>(rest % 2);
  // Over the thirds first: neighbours in time should not be neighbours in the pixel.
  const int turned = (k * 3 + 1) % count;
  return {(static_cast<float>(count % 3 == 0 ? k : turned) + 0.5f) / static_cast<float>(count) - 0.5f,
          radical_inverse + 0.5f / static_cast<float>(count) - 0.5f};
}

double poisson(Random& random, double mean) {
  if (mean > 50) return std::max(0.0, std::round(mean + std::sqrt(mean) * random.normal()));
  // Inversion: Devroye, Non-uniform random variate generation, 1986, X.3.3.
  double probability = std::exp(-mean), sum = probability;
  const double u = random.uniform(0, 1);
  int count = 0;
  while (u > sum && count < 200) {
    probability *= mean / ++count;
    sum += probability;
  }
  return count;
}

// cos^4 of the angle to the axis, as strong as asked.
cv::Mat vignette(const Camera& camera, double strength) {
  cv::Mat factor(camera.height, camera.width, CV_32F, cv::Scalar(1));
  if (strength == 0) return factor;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto ray = camera.bearing({u, v});
      const double cosine = ray ? std::max(0.0, ray->z()) : 0;
      factor.at<float>(v, u) = static_cast<float>(1 + strength * (std::pow(cosine, 4) - 1));
    }
  return factor;
}

std::uint8_t to_byte(double light, double gamma) {
  const double x = std::clamp(light, 0.0, 1.0);
  const double shown = gamma > 0 ? std::pow(x, 1 / gamma)
                                 : (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
  return static_cast<std::uint8_t>(255 * shown + 0.5);
}

// Bytes by a table of light from 0 to 1.
std::vector<std::uint8_t> byte_table(double gamma) {
  constexpr int kSize = 1 << 16;
  std::vector<std::uint8_t> table(kSize + 1);
  for (int i = 0; i <= kSize; ++i) table[i] = to_byte(static_cast<double>(i) / kSize, gamma);
  return table;
}

}  // namespace

void ImagingOptions::check(double time_between_frames) const {
  expect_imaging(exposure_time >= 0, "exposure time", exposure_time, "0 or a positive number of seconds");
  expect_imaging(readout_time >= 0, "rolling shutter", readout_time, "0 or a positive number of seconds");
  expect_imaging(exposure_time <= time_between_frames, "exposure time", exposure_time,
                 "at most the " + std::to_string(time_between_frames) + " s between two frames");
  expect_imaging(readout_time <= time_between_frames, "rolling shutter", readout_time,
                 "at most the " + std::to_string(time_between_frames) + " s between two frames");
  expect_imaging(blur_samples >= 1 && blur_samples <= 256, "blur samples", blur_samples, "1 to 256");
  expect_imaging(photons >= 0 && photons <= 1e7, "photons", photons, "0 (no noise) to 1e7 in a white pixel");
  expect_imaging(read_noise >= 0 && std::isfinite(read_noise), "read noise", read_noise,
                 "0 or a positive number of electrons");
  expect_imaging(read_noise == 0 || photons > 0, "read noise", read_noise, "0 where photons is 0");
  expect_imaging(gamma == 0 || (gamma >= 0.1 && gamma <= 10), "gamma", gamma, "0.1 to 10, or 0 for sRGB");
  expect_imaging(vignetting >= 0 && vignetting <= 1, "vignetting", vignetting, "0 to 1");
}

cv::Mat expose(const RgbdSensor& sensor, const RayTracer& tracer, const Path& path, double time,
               const ImagingOptions& options) {
  const int rows = sensor.options().camera.height;
  if (options.exposure_time == 0)
    return sensor.light(tracer, row_poses(path, time, options.readout_time, rows));
  std::vector<RgbdSensor::Instant> instants;
  for (int k = 0; k < options.blur_samples; ++k) {
    const double instant = time + options.exposure_time * ((k + 0.5) / options.blur_samples - 0.5);
    instants.push_back(
        {row_poses(path, instant, options.readout_time, rows), offset_of_sample(k, options.blur_samples)});
  }
  return sensor.mean_light(tracer, path(time).world_from_cam, instants);
}

cv::Mat develop(const cv::Mat& light, const Camera& camera, const ImagingOptions& options,
                std::uint64_t seed) {
  const std::vector<std::uint8_t> table = byte_table(options.gamma);
  const cv::Mat factor = vignette(camera, options.vignetting);
  cv::Mat image(light.size(), CV_8UC3);
  tbb::parallel_for(0, light.rows, [&](int v) {
    Random random(seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(v + 1) * 0x100000001b3u);
    for (int u = 0; u < light.cols; ++u) {
      cv::Vec3b& byte = image.at<cv::Vec3b>(v, u);
      for (int k = 0; k < 3; ++k) {
        double x = static_cast<double>(light.at<cv::Vec3f>(v, u)[k]) * factor.at<float>(v, u);
        if (options.photons > 0) {
          const double electrons = std::min(1e9, x * options.photons);
          x = poisson(random, electrons);
          if (options.read_noise > 0) x += options.read_noise * random.normal();
          x /= options.photons;
        }
        byte[k] = table[static_cast<std::size_t>(std::clamp(x, 0.0, 1.0) * 65536)];
      }
    }
  });
  return image;
}

}  // namespace framewise
