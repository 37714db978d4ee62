// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vector>

#include "framewise/simulation/path.h"
#include "framewise/simulation/random.h"

namespace framewise {
namespace {

constexpr double kDegree = M_PI / 180;

class Sines {
 public:
  struct Term {
    double amplitude, period;
  };

  // Phases are random, periods within 15 %.
  Sines(Random& random, std::initializer_list<Term> terms) {
    for (const Term& term : terms)
      waves_.push_back({term.amplitude, 2 * M_PI / (term.period * random.uniform(0.85, 1.15)),
                        random.uniform(0, 2 * M_PI)});
  }

  double operator()(double time) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.amplitude * std::sin(wave.frequency * time + wave.phase);
    return sum;
  }

 private:
  struct Wave {
    double amplitude, frequency, phase;
  };
  std::vector<Wave> waves_;
};

// Optical axes of a camera that looks along a heading (from x, about z), a pitch above the horizon, and
// rolled.
Eigen::Matrix3d look(double heading, double pitch, double roll) {
  Eigen::Matrix3d world_from_level;  // level: looks along x of the world
  world_from_level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return (Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()))
             .toRotationMatrix() *
         world_from_level * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace

Path handheld_path(const Eigen::AlignedBox3d& free_space, std::uint64_t seed) {
  Random random(seed ^ 0x5061746800000000u);
  const Eigen::Vector3d middle = free_space.center(), half = 0.5 * free_space.sizes();
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
  return [=](double time) {
    const double angle = start + way_round * pace * time;
    const double reach = 0.72 * (1 + distance(time));
    const Eigen::Vector3d from_middle(reach * std::cos(angle) * half.x(), reach * std::sin(angle) * half.y(),
                                      height(time) * half.z());
    const Eigen::Vector3d tremor(tremor_x(time), tremor_y(time), tremor_z(time));
    return Pose{look(angle + M_PI + heading(time), -13 * kDegree + pitch(time), roll(time)),
                middle + from_middle + tremor};
  };
}

}  // namespace framewise
