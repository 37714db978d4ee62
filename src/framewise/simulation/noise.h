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
  // Clamped: so far out that whole numbers end, it is still bounded.
  const float fx = smooth(clamp01(x - static_cast<float>(ix))),
              fy = smooth(clamp01(y - static_cast<float>(iy)));
  // A lighter hash than hash(): this is where much of the time of a frame goes.
  const std::uint32_t left = static_cast<std::uint32_t>(ix) * 0x8da6b343u, right = left + 0x8da6b343u;
  const std::uint32_t low = static_cast<std::uint32_t>(iy) * 0xd8163841u + seed * 0xcb1ab31fu,
                      high = low + 0xd8163841u;
  const auto at = [](std::uint32_t h) {
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return static_cast<float>(static_cast<std::int32_t>(h ^ (h >> 13))) * (1.0f / 2147483648.0f);
  };
  const float a = at(left + low), b = at(right + low), c = at(left + high), d = at(right + high);
  const float below = a + (b - a) * fx, above = c + (d - c) * fx;
  return below + (above - below) * fy;
}

// At most 10 octaves of value noise at (x, y), each gain times the last, of those larger than the 1.5th part
// of `pixels`. Octaves are turned against each other so that their lattices do not line up.
float octaves_of_noise(float x, float y, float pixels, float gain, std::uint32_t seed);

// From one wavelength (m) down to where the footprint hides them.
inline float fractal_noise(float u, float v, float wavelength, float gain, float footprint,
                           std::uint32_t seed) {
  const float pixels = wavelength / footprint;
  return pixels > 1.5f ? octaves_of_noise(u / wavelength, v / wavelength, pixels, gain, seed) : 0;
}

// hash01(k, y, seed) of k = 0 to count - 1.
void hash01_of_each(int count, std::uint32_t y, std::uint32_t seed, float* values);

}  // namespace framewise
