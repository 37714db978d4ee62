// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace framewise {

// Linear red, green, blue: light, not display values.
struct Color {
  float r = 0, g = 0, b = 0;

  Color operator+(const Color& o) const { return {r + o.r, g + o.g, b + o.b}; }
  Color operator*(const Color& o) const { return {r * o.r, g * o.g, b * o.b}; }
  Color operator*(float s) const { return {r * s, g * s, b * s}; }
  Color& operator+=(const Color& o) { return *this = *this + o; }
};

inline Color mix(const Color& a, const Color& b, float s) { return a * (1 - s) + b * s; }

// From the usual display notation 0xRRGGBB (IEC 61966-2-1).
inline Color srgb(std::uint32_t hex) {
  const auto linear = [](std::uint32_t value) {
    const float c = (value & 255u) / 255.0f;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  };
  return {linear(hex >> 16), linear(hex >> 8), linear(hex)};
}

}  // namespace framewise
