// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths along the route of a scene: walk, drone race.
#include <algorithm>
#include <cmath>
#include <memory>

#include "framewise/simulation/imu.h"
#include "framewise/simulation/path.h"
#include "framewise/simulation/route.h"
#include "framewise/simulation/se3_spline.h"
#include "framewise/simulation/varying.h"

namespace framewise {

using Eigen::Vector3d;

namespace {

struct Looks {
  std::vector<double> heading, pitch, roll;
};

// The direction of the way, as it is on the mean over so many steps to both sides. Grows or falls by whole
// turns over a round.
std::vector<double> headings(const Round& round, int reach) {
  const int n = static_cast<int>(round.positions.size());
  std::vector<double> turn(round.positions.size());  // from one step to the next
  double first = 0, before = 0;
  for (int i = 0; i <= n; ++i) {
    const Vector3d way = round.positions[(i + 1) % n] - round.positions[i % n];
    const double heading = std::atan2(way.y(), way.x());
    if (i == 0)
      first = heading;
    else
      turn[i - 1] = std::remainder(heading - before, 2 * M_PI);
    before = heading;
  }
  turn = smoothed(turn, reach);
  std::vector<double> heading{first};
  for (int i = 0; i + 1 < n; ++i) heading.push_back(heading.back() + turn[i]);
  return heading;
}

// Poses of a round, repeated for ever from a place in it.
Path repeated(const Round& round, const Looks& looks, double start) {
  constexpr int kExtra = 3;  // steps beyond both ends, so that the joint is like any other place
  const int n = static_cast<int>(round.positions.size());
  Trajectory poses;
  for (int i = -kExtra; i <= n + kExtra; ++i) {
    const int k = (i + n) % n;
    poses.add(round.step * i, {look(looks.heading[k], looks.pitch[k], looks.roll[k]), round.positions[k]});
  }
  return [spline = std::make_shared<const Se3Spline>(poses), period = round.period(), start](double time) {
    const double at = std::fmod(start + time, period);
    return (*spline)(at < 0 ? at + period : at);
  };
}

// The most of a quantity over a round.
template <typename Function>
double most(const Path& path, const Round& round, Function quantity) {
  double most = 0;
  for (int i = 0; i < 4 * static_cast<int>(round.positions.size()); ++i)
    most = std::max(most, quantity(path(0.25 * round.step * i)));
  return most;
}

Looks level_looks(const Round& round, double pitch, int reach) {
  return {headings(round, reach), std::vector<double>(round.positions.size(), pitch),
          std::vector<double>(round.positions.size(), 0.0)};
}

// Leaning into the turns as the sum of weight and centrifugal force asks, nose down where it goes faster.
void bank(const Round& round, int reach, Looks& looks) {
  constexpr double kMostLean = 60 * kDegree, kMostNod = 12 * kDegree;
  const int n = static_cast<int>(round.positions.size());
  std::vector<double> lean(round.positions.size()), nod(round.positions.size());
  for (int i = 0; i < n; ++i) {
    const Vector3d before = round.positions[(i + n - 1) % n], here = round.positions[i],
                   after = round.positions[(i + 1) % n];
    const Vector3d acceleration = (after - 2 * here + before) / (round.step * round.step);
    const Vector3d ahead = (after - before).normalized(), left = Vector3d::UnitZ().cross(ahead);
    lean[i] = std::clamp(-std::atan2(acceleration.dot(left), kGravity), -kMostLean, kMostLean);
    nod[i] = std::clamp(-0.5 * std::atan2(acceleration.dot(ahead), kGravity), -kMostNod, kMostNod);
  }
  lean = smoothed(lean, reach);
  nod = smoothed(nod, reach);
  for (int i = 0; i < n; ++i) {
    looks.roll[i] += lean[i];
    looks.pitch[i] += nod[i];
  }
}

// Steps of the feet: up and down with each, to the side and over with every other.
void bob(Random& random, Round& round, Looks& looks) {
  const int n = static_cast<int>(round.positions.size());
  const double steps = std::max(1.0, std::round(round.period() * 1.9 / 2)) * 2;  // an even number a round
  const double phase = random.uniform(0, 2 * M_PI), glances = std::max(1.0, std::round(round.period() / 9));
  std::vector<Vector3d> moved = round.positions;
  for (int i = 0; i < n; ++i) {
    const double turn = 2 * M_PI * i / n, gait = steps * turn + phase;
    const Vector3d left(-std::sin(looks.heading[i]), std::cos(looks.heading[i]), 0);
    moved[i] += 0.018 * std::sin(0.5 * gait) * left + Vector3d(0, 0, 0.022 * std::sin(gait));
    looks.heading[i] += 7 * kDegree * std::sin(glances * turn) + 0.6 * kDegree * std::sin(0.5 * gait + 0.4);
    looks.pitch[i] +=
        2.5 * kDegree * std::sin((glances + 1) * turn + phase) + 0.5 * kDegree * std::sin(gait + 1);
    looks.roll[i] += 0.8 * kDegree * std::sin(0.5 * gait + 0.8);
  }
  round.positions = moved;
}

}  // namespace

std::vector<Vector3d> round_way(const Eigen::AlignedBox3d& box) {
  constexpr int kCorners = 16;
  std::vector<Vector3d> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners;
    corners.push_back(box.center() + 0.45 * Vector3d(box.sizes().x() * std::cos(angle),
                                                     box.sizes().y() * std::sin(angle), 0));
  }
  return corners;
}

Path walk_path(const PathSpace& space, std::uint64_t seed) {
  Random random(seed ^ 0x57616c6bu);
  Round round = ride(space.route, {1.3, 1.5, 0.8, 80 * kDegree}, 0.02);
  Looks looks = level_looks(round, space.pitch, 12);
  bob(random, round, looks);
  return repeated(round, looks, random.uniform(0, round.period()));
}

Path drone_race_path(const PathSpace& space, std::uint64_t seed) {
  constexpr double kFastest = 15, kFastestTurn = 600 * kDegree;
  Random random(seed ^ 0x52616365u);
  Round round = ride(space.route, {kFastest, 35, 20, 420 * kDegree}, 0.02);
  const int reach = static_cast<int>(0.08 / round.step);
  Looks looks = level_looks(round, space.pitch, reach);
  bank(round, reach, looks);
  const double start = random.uniform(0, 1);
  const Path path = repeated(round, looks, 0);
  // A little slower all the way round where smoothing went beyond a limit.
  const double excess =
      std::max({1.0, most(path, round, [](const Motion& m) { return m.velocity.norm(); }) / kFastest,
                most(path, round, [](const Motion& m) { return m.angular_rate.norm(); }) / kFastestTurn});
  round.step *= 1.001 * excess;
  return repeated(round, looks, start * round.period());
}

}  // namespace framewise
