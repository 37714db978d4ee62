// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace framewise {

// Angular rates over time: rates[i] at times[i] (s), times strictly increasing; of the sensor against the
// world, in the sensor's own axes (rad/s).
struct Gyroscope {
  std::vector<double> times;
  std::vector<Eigen::Vector3d> rates;
  Eigen::Matrix3d cam_from_gyro = Eigen::Matrix3d::Identity();

  std::size_t size() const { return times.size(); }
  bool empty() const { return times.empty(); }
};

// The rotation cam2_from_cam1 between two times, by integrating rates that are linear between samples: with h
// the time from w0 to w1, a stretch turns the sensor by
//   exp(h (w0 + w1) / 2 + h^2 (w0 x w1) / 12),
// the Magnus expansion to fourth order. With time2 before time1 the inverse of the way back. Empty where a
// time lies outside the samples, or where two samples between the times are more than max_gap apart (s).
//   Iserles et al., Lie-group methods, Acta Numerica 2000.
// Throws std::invalid_argument where there are not as many rates as times.
std::optional<Eigen::Matrix3d> rotation_between(const Gyroscope& gyroscope, double time1, double time2,
                                                double max_gap);

}  // namespace framewise
