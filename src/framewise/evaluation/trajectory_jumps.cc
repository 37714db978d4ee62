// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/trajectory_jumps.h"

#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr double kLeast_m = 0.5, kLeast_rad = 30 * M_PI / 180, kTimesAsFast = 10;

struct Leg {
  double length, angle, seconds;
};

std::vector<Leg> legs_of(const Trajectory& trajectory) {
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const Pose &a = trajectory.world_from_cam[i - 1], &b = trajectory.world_from_cam[i];
    legs.push_back({(b.t - a.t).norm(), rotation_angle(a.R.transpose() * b.R),
                    trajectory.times[i] - trajectory.times[i - 1]});
  }
  return legs;
}

bool leaps(const std::vector<Leg>& legs, std::size_t i, double Leg::*way, double least) {
  if (!(legs[i].*way > least)) return false;
  double neighbour = 0;
  if (i > 0) neighbour = legs[i - 1].*way / legs[i - 1].seconds;
  if (i + 1 < legs.size()) neighbour = std::max(neighbour, legs[i + 1].*way / legs[i + 1].seconds);
  return legs[i].*way / legs[i].seconds > kTimesAsFast * neighbour;
}

}  // namespace

std::vector<std::size_t> find_jumps(const Trajectory& trajectory) {
  const std::vector<Leg> legs = legs_of(trajectory);
  std::vector<std::size_t> jumps;
  if (legs.size() < 2) return jumps;  // nothing to compare with
  for (std::size_t i = 0; i < legs.size(); ++i)
    if (leaps(legs, i, &Leg::length, kLeast_m) || leaps(legs, i, &Leg::angle, kLeast_rad))
      jumps.push_back(i + 1);
  return jumps;
}

}  // namespace framewise
