// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/gyroscope.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

Eigen::Vector3d rate_at(const Gyroscope& gyroscope, std::size_t i, double time) {
  const double s = (time - gyroscope.times[i]) / (gyroscope.times[i + 1] - gyroscope.times[i]);
  return (1 - s) * gyroscope.rates[i] + s * gyroscope.rates[i + 1];
}

}  // namespace

std::optional<Eigen::Matrix3d> rotation_between(const Gyroscope& gyroscope, double time1, double time2,
                                                double max_gap) {
  const auto& times = gyroscope.times;
  if (times.size() != gyroscope.rates.size())
    throw std::invalid_argument("gyroscope: found " + std::to_string(gyroscope.rates.size()) +
                                " rates, expected " + std::to_string(times.size()) + ", one for each time");
  if (time2 < time1) {
    const auto back = rotation_between(gyroscope, time2, time1, max_gap);
    return back ? std::optional<Eigen::Matrix3d>(back->transpose()) : std::nullopt;
  }
  if (times.empty() || !(time1 >= times.front() && time2 <= times.back())) return std::nullopt;

  Eigen::Matrix3d gyro1_from_gyro2 = Eigen::Matrix3d::Identity();
  std::size_t i = std::upper_bound(times.begin(), times.end(), time1) - times.begin() - 1;
  for (double from = time1; from < time2; ++i) {
    if (times[i + 1] - times[i] > max_gap) return std::nullopt;
    const double to = std::min(times[i + 1], time2), h = to - from;
    const Eigen::Vector3d w0 = rate_at(gyroscope, i, from), w1 = rate_at(gyroscope, i, to);
    gyro1_from_gyro2 = gyro1_from_gyro2 * so3_exp(h / 2 * (w0 + w1) + h * h / 12 * w0.cross(w1));
    from = to;
  }
  const Eigen::Matrix3d& C = gyroscope.cam_from_gyro;
  return Eigen::Matrix3d(C * gyro1_from_gyro2.transpose() * C.transpose());
}

}  // namespace framewise
