// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "framewise/geometry/imu_reading.h"
#include "framewise/simulation/path.h"

namespace framewise {

// An inertial unit at the camera's centre, its axes those of the camera. The defaults are those of EuRoC's
// ADIS16448 (Burri et al., The EuRoC micro aerial vehicle datasets, IJRR 2016); 0 switches a noise off.
struct ImuOptions {
  double rate_hz = 200;
  double gyroscope_noise = 1.7e-4;        // density of white noise (rad/s / sqrt(Hz))
  double gyroscope_bias_walk = 1.9e-5;    // of the bias (rad/s^2 / sqrt(Hz))
  double accelerometer_noise = 2e-3;      // m/s^2 / sqrt(Hz)
  double accelerometer_bias_walk = 3e-3;  // m/s^3 / sqrt(Hz)
  double time_offset = 0;  // the unit's stamps are late by this: what it stamps t was at t - time_offset (s)

  // Throws std::invalid_argument naming the option, what was found and what was expected.
  void check() const;
};

inline constexpr double kGravity = 9.81;  // of the simulated world, along -z (m/s^2)

// What a unit without fault reads from one time to another, both included, at the rate:
//   angular_rate = omega,   specific_force = R^T (a - g),   with world_from_unit = (R, t), a = t'', g = -g0 z
std::vector<ImuReading> true_imu_readings(const Path& path, double from, double to, double rate_hz);

// What the unit reads, of true readings at its rate: with h the time between two,
//   reading_k = true_k + bias_k + noise / sqrt(h) n_k,   bias_k+1 = bias_k + walk sqrt(h) m_k,   bias_0 = 0,
// n and m standard normal. Stamps are moved by the offset; what it moves before 0 is left out.
//   Crassidis, Sigma-point Kalman filtering for integrated GPS and inertial navigation, 2006.
std::vector<ImuReading> imu_readings(const std::vector<ImuReading>& truth, const ImuOptions& options,
                                     std::uint64_t seed);

}  // namespace framewise
