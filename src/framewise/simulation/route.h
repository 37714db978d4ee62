// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace framewise {

// What limits the speed on a way. Each is kept at the points of the way, up to the smoothing between them.
struct RouteLimits {
  double speed = 1;       // m/s
  double sideways = 10;   // acceleration across the way, in turns (m/s^2)
  double lengthways = 5;  // acceleration along it (m/s^2)
  double turn_rate = 3;   // of the way's direction (rad/s)
};

// A round on a closed way, by even steps of time; the last is one step before the first again.
struct Round {
  double step;  // s
  std::vector<Eigen::Vector3d> positions;
  double period() const { return step * static_cast<double>(positions.size()); }
};

// Once round a smooth curve through the corners as fast as the limits allow. About `step` long steps (s). The
// corners: at least three, no two successive ones in one place.
Round ride(const std::vector<Eigen::Vector3d>& corners, const RouteLimits& limits, double step);

// The mean over so many neighbours to both sides on a closed way, four times over: nearly Gaussian.
std::vector<double> smoothed(std::vector<double> values, int reach);

}  // namespace framewise
