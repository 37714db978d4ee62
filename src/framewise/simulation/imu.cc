// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/imu.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/simulation/random.h"

namespace framewise {
namespace {

using Eigen::Vector3d;

void expect(bool right, const char* name, double found, const char* expected) {
  if (!right)
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(found) + ", expected " +
                                expected);
}

Vector3d normal3(Random& random) { return {random.normal(), random.normal(), random.normal()}; }

}  // namespace

void ImuOptions::check() const {
  expect(rate_hz >= 1 && rate_hz <= 10000, "imu rate", rate_hz, "1 to 10000 Hz");
  const auto density = [](const char* name, double value) {
    expect(value >= 0 && std::isfinite(value), name, value, "0 or a positive number");
  };
  density("gyroscope noise", gyroscope_noise);
  density("gyroscope bias walk", gyroscope_bias_walk);
  density("accelerometer noise", accelerometer_noise);
  density("accelerometer bias walk", accelerometer_bias_walk);
  expect(std::abs(time_offset) <= 1, "imu time offset", time_offset, "-1 to 1 s");
}

std::vector<ImuReading> true_imu_readings(const Path& path, double from, double to, double rate_hz) {
  std::vector<ImuReading> readings;
  // The last reading may fall on the end but for rounding.
  const auto last = static_cast<long>(std::floor((to - from) * rate_hz + 1e-6));
  for (long i = 0; i <= last; ++i) {
    const double time = std::fmin(from + static_cast<double>(i) / rate_hz, to);
    const Motion motion = path(time);
    readings.push_back(
        {time, motion.angular_rate,
         motion.world_from_cam.R.transpose() * (motion.acceleration + Vector3d(0, 0, kGravity))});
  }
  return readings;
}

std::vector<ImuReading> imu_readings(const std::vector<ImuReading>& truth, const ImuOptions& options,
                                     std::uint64_t seed) {
  options.check();
  // Streams of their own, so that switching one noise off leaves the others as they were.
  Random rate_noise(seed ^ 0x67796e6fu), rate_walk(seed ^ 0x67797277u), force_noise(seed ^ 0x61636e6fu),
      force_walk(seed ^ 0x61637277u);
  const double root = std::sqrt(options.rate_hz);
  Vector3d rate_bias = Vector3d::Zero(), force_bias = Vector3d::Zero();
  std::vector<ImuReading> readings = truth;
  for (ImuReading& reading : readings) {
    reading.time += options.time_offset;
    reading.angular_rate += rate_bias + options.gyroscope_noise * root * normal3(rate_noise);
    reading.specific_force += force_bias + options.accelerometer_noise * root * normal3(force_noise);
    rate_bias += options.gyroscope_bias_walk / root * normal3(rate_walk);
    force_bias += options.accelerometer_bias_walk / root * normal3(force_walk);
  }
  std::erase_if(readings, [](const ImuReading& reading) { return reading.time < 0; });
  return readings;
}

}  // namespace framewise
