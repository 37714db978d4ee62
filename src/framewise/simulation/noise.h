// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace framewise {

// Repeatable noise over the plane, for textures. Everything is a pure function of position and seed.

inline std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = x * 0x8da6b343u + y * 0xd8163841u + seed * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return h ^ (h >> 15);
}

// Uniform in [0, 1).
inline float hash01(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return static_cast<float>(hash(x, y, seed) >> 8) * (1.0f / 16777216.0f);
}

inline float clamp01(float x) { return x < 0 ? 0 : (x > 1 ? 1 : x); }
inline float smooth(float x) { return x * x * (3 - 2 * x); }
inline int floor_int(float x) {
  const int i = static_cast<int>(x);
  return i - (static_cast<float>(i) > x);
}

// A step from 0 to 1 at x = 0, blurred over the width of a pixel's footprint.
inline float edge(float x, float footprint) { return clamp01(x / footprint + 0.5f); }

// How much of a pattern of this size survives under the footprint: all above four pixels, nothing at one and
// a half.
inline float visible(float size, float footprint) {
  return smooth(clamp01((size / footprint - 1.5f) * 0.4f));
}

// Value noise in [-1, 1] with one lattice point per unit.
inline float value_noise(float x, float y, std::uint32_t seed) {
  const int ix = floor_int(x), iy = floor_int(y);
  const float fx = smooth(x - static_cast<float>(ix)), fy = smooth(y - static_cast<float>(iy));
  const float a = hash01(ix, iy, seed), b = hash01(ix + 1, iy, seed);
  const float c = hash01(ix, iy + 1, seed), d = hash01(ix + 1, iy + 1, seed);
  const float low = a + (b - a) * fx, high = c + (d - c) * fx;
  return 2 * (low + (high - low) * fy) - 1;
}

// Octaves of value noise from one wavelength (m) down to where the footprint hides them, each gain times the
// last. Octaves are turned against each other so that their lattices do not line up.
inline float fractal_noise(float u, float v, float wavelength, float gain, float footprint,
                           std::uint32_t seed) {
  float sum = 0, amplitude = 1;
  float x = u / wavelength, y = v / wavelength;
  for (int octave = 0; octave < 10; ++octave) {
    const float strength = visible(wavelength, footprint);
    if (strength <= 0) break;
    sum += strength * amplitude * value_noise(x, y, seed + octave);
    const float turned = 1.6f * x - 1.2f * y;
    y = 1.2f * x + 1.6f * y;
    x = turned;
    wavelength *= 0.5f;
    amplitude *= gain;
  }
  return sum;
}

}  // namespace framewise
