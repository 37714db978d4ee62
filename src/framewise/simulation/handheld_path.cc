// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/path.h"
#include "framewise/simulation/varying.h"

namespace framewise {

Path handheld_path(const PathSpace& space, std::uint64_t seed) {
  Random random(seed ^ 0x5061746800000000u);
  const Eigen::Vector3d middle = space.free_space.center(), half = 0.5 * space.free_space.sizes();
  const double start = random.uniform(0, 2 * M_PI), way_round = random.below(2) ? 1 : -1;
  const double pace = random.uniform(0.21, 0.25);  // rad/s around the middle
  const Sines distance(random, {{0.10, 17}, {0.05, 7.3}}), height(random, {{0.45, 11}, {0.2, 4.7}});
  const Sines heading(random,
                      {{17 * kDegree, 21}, {4 * kDegree, 8}, {0.35 * kDegree, 1.1}, {0.10 * kDegree, 0.43}});
  const Sines pitch(random,
                    {{6 * kDegree, 13}, {2 * kDegree, 5.1}, {0.4 * kDegree, 0.9}, {0.10 * kDegree, 0.37}});
  const Sines roll(random, {{2.5 * kDegree, 9}, {0.3 * kDegree, 1.3}});
  const Sines tremor_x(random, {{0.012, 1.7}, {0.002, 0.5}}), tremor_y(random, {{0.012, 1.9}, {0.002, 0.55}}),
      tremor_z(random, {{0.012, 1.1}, {0.002, 0.47}});
  return [=, mean_pitch = space.pitch](double time) {
    const Varying angle{start + way_round * pace * time, way_round * pace, 0};
    const Varying reach = 0.72 * (1 + distance(time));
    const Varying x = half.x() * (reach * cos(angle)), y = half.y() * (reach * sin(angle)),
                  z = half.z() * height(time);
    const Varying position[] = {(middle.x() + x) + tremor_x(time), (middle.y() + y) + tremor_y(time),
                                (middle.z() + z) + tremor_z(time)};
    return motion_of(position, Varying{angle.value + M_PI, angle.rate, 0} + heading(time),
                     mean_pitch + pitch(time), roll(time));
  };
}

}  // namespace framewise
