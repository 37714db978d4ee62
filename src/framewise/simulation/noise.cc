// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/noise.h"

#include <array>

#include "framewise/image/chosen_at_run_time.h"

// No OpenCV and no Eigen in this file, and no contraction of products and sums (CMakeLists.txt): what is
// computed must not depend on the instruction set.
namespace framewise {
namespace {

constexpr int kLanes = 8, kOctaves = 10;  // octaves side by side in a register; all there are

// Octave k is at (x + i y) (1.6 + 1.2 i)^k: twice as fine as the one before, and turned against it.
struct Octaves {
  std::array<float, 2 * kLanes> real{}, imaginary{}, size{};

  constexpr Octaves() {
    double re = 1, im = 0, halved = 1;
    for (int k = 0; k < kOctaves; ++k) {
      real[k] = static_cast<float>(re);
      imaginary[k] = static_cast<float>(im);
      size[k] = static_cast<float>(halved);
      const double turned = 1.6 * re - 1.2 * im;
      im = 1.2 * re + 1.6 * im;
      re = turned;
      halved *= 0.5;
    }
  }
};
constexpr Octaves kTurned;

}  // namespace

FRAMEWISE_CHOSEN_AT_RUN_TIME float octaves_of_noise(float x, float y, float pixels, float gain,
                                                    std::uint32_t seed) {
  const float gain2 = gain * gain, gain4 = gain2 * gain2;
  float sum = 0, amplitude = 1;
  for (int first = 0; first < kOctaves && pixels * kTurned.size[first] > 1.5f; first += kLanes) {
    float terms[kLanes];
    for (int k = 0; k < kLanes; ++k) {
      const float re = kTurned.real[first + k], im = kTurned.imaginary[first + k];
      const float seen = visible(pixels * kTurned.size[first + k], 1);
      // What is too fine to be seen may be too far out for whole numbers.
      const float u = seen > 0 ? re * x - im * y : 0, v = seen > 0 ? im * x + re * y : 0;
      const float power = (k & 1 ? gain : 1) * (k & 2 ? gain2 : 1) * (k & 4 ? gain4 : 1);
      terms[k] = power * seen * value_noise(u, v, seed + static_cast<std::uint32_t>(first + k));
    }
    sum += amplitude * (((terms[0] + terms[4]) + (terms[2] + terms[6])) +
                        ((terms[1] + terms[5]) + (terms[3] + terms[7])));
    amplitude = gain4 * gain4;
  }
  return sum;
}

FRAMEWISE_CHOSEN_AT_RUN_TIME void hash01_of_each(int count, std::uint32_t y, std::uint32_t seed,
                                                 float* values) {
  for (int k = 0; k < count; ++k) values[k] = hash01(static_cast<std::uint32_t>(k), y, seed);
}

}  // namespace framewise
