// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "framewise/simulation/path.h"
#include "framewise/simulation/random.h"

namespace framewise {

inline constexpr double kDegree = M_PI / 180;

// A number that varies over time, with its first two derivatives: what is computed of such numbers has exact
// derivatives too.
struct Varying {
  double value = 0, rate = 0, acceleration = 0;
};

inline Varying operator+(const Varying& a, const Varying& b) {
  return {a.value + b.value, a.rate + b.rate, a.acceleration + b.acceleration};
}
inline Varying operator+(double a, const Varying& b) { return {a + b.value, b.rate, b.acceleration}; }
inline Varying operator*(const Varying& a, const Varying& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.acceleration * b.value + 2 * a.rate * b.rate + a.value * b.acceleration};
}
inline Varying operator*(double a, const Varying& b) { return {a * b.value, a * b.rate, a * b.acceleration}; }

inline Varying sin(const Varying& a) {
  const double s = std::sin(a.value), c = std::cos(a.value);
  return {s, c * a.rate, c * a.acceleration - s * a.rate * a.rate};
}
inline Varying cos(const Varying& a) {
  const double s = std::sin(a.value), c = std::cos(a.value);
  return {c, -s * a.rate, -s * a.acceleration - c * a.rate * a.rate};
}

// A sum of sines over time.
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

  Varying operator()(double time) const {
    Varying sum;
    for (const Wave& wave : waves_)
      sum = sum + wave.amplitude * sin(Varying{wave.frequency * time + wave.phase, wave.frequency, 0});
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
Eigen::Matrix3d look(double heading, double pitch, double roll);

// The motion of a camera by its position and where it looks.
Motion motion_of(const Varying (&position)[3], const Varying& heading, const Varying& pitch,
                 const Varying& roll);

}  // namespace framewise
