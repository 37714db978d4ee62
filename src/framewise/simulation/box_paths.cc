// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths within the free space: orbit, hover, pure rotation, forward.
#include <algorithm>

#include "framewise/simulation/path.h"
#include "framewise/simulation/varying.h"

namespace framewise {

using Eigen::Vector3d;

Path orbit_path(const PathSpace& space, std::uint64_t seed) {
  Random random(seed ^ 0x4f72626974u);
  const Vector3d middle = space.free_space.center(), half = 0.5 * space.free_space.sizes();
  const double start = random.uniform(0, 2 * M_PI), way_round = random.below(2) ? 1 : -1;
  constexpr double kReach = 0.9;  // of the way to the border
  const double pace = way_round * 0.5 / (kReach * std::max(half.x(), half.y()));
  return [=, pitch = space.pitch](double time) {
    const Varying angle{start + pace * time, pace, 0};
    const Varying position[] = {middle.x() + kReach * half.x() * cos(angle),
                                middle.y() + kReach * half.y() * sin(angle),
                                {middle.z()}};
    return motion_of(position, M_PI + angle, {pitch}, {});
  };
}

Path hover_path(const PathSpace& space, std::uint64_t seed) {
  Random random(seed ^ 0x486f766572u);
  const Vector3d middle = space.free_space.center();
  const double ahead = random.uniform(0, 2 * M_PI);
  const Sines x(random, {{0.035, 5}, {0.01, 1.3}, {0.002, 0.3}}),
      y(random, {{0.035, 6}, {0.01, 1.5}, {0.002, 0.35}}), z(random, {{0.03, 4}, {0.005, 0.9}});
  const Sines heading(random, {{2 * kDegree, 7}, {0.6 * kDegree, 1.1}}),
      pitch(random, {{1.2 * kDegree, 3.1}, {0.5 * kDegree, 0.8}, {0.1 * kDegree, 0.2}}),
      roll(random, {{1.2 * kDegree, 2.9}, {0.5 * kDegree, 0.7}, {0.1 * kDegree, 0.19}});
  return [=, mean_pitch = space.pitch](double time) {
    const Varying position[] = {middle.x() + x(time), middle.y() + y(time), middle.z() + z(time)};
    return motion_of(position, ahead + heading(time), mean_pitch + pitch(time), roll(time));
  };
}

Path pure_rotation_path(const PathSpace& space, std::uint64_t seed) {
  Random random(seed ^ 0x5475726eu);
  const Vector3d middle = space.free_space.center();
  const double start = random.uniform(0, 2 * M_PI), pace = (random.below(2) ? 20 : -20) * kDegree;
  const Sines pitch(random, {{8 * kDegree, 9}, {2 * kDegree, 2.3}}), roll(random, {{5 * kDegree, 7}});
  return [=, mean_pitch = space.pitch](double time) {
    const Varying position[] = {{middle.x()}, {middle.y()}, {middle.z()}};
    return motion_of(position, {start + pace * time, pace, 0}, mean_pitch + pitch(time), roll(time));
  };
}

Path forward_path(const PathSpace& space, std::uint64_t seed) {
  Random random(seed ^ 0x466f7277617264u);
  const Vector3d middle = space.free_space.center(), size = space.free_space.sizes();
  const double heading = (size.x() >= size.y() ? 0 : M_PI / 2) + (random.below(2) ? M_PI : 0);
  const double phase = random.uniform(0, 2 * M_PI);
  const Vector3d axis = look(heading, space.pitch, 0).col(2);
  double length = 1e9;  // of the line through the middle along the axis, inside the box
  for (int k = 0; k < 3; ++k)
    if (std::abs(axis[k]) > 1e-9) length = std::min(length, size[k] / std::abs(axis[k]));
  const double reach = 0.45 * length, pace = 0.8 / reach;
  return [=, pitch = space.pitch](double time) {
    const Varying along = -reach * cos(Varying{phase + pace * time, pace, 0});
    const Varying position[] = {middle.x() + axis.x() * along, middle.y() + axis.y() * along,
                                middle.z() + axis.z() * along};
    return motion_of(position, {heading}, {pitch}, {});
  };
}

}  // namespace framewise
