// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "framewise/simulation/noise.h"
#include "framewise/simulation/textures.h"

// What textures are made of, and the textures: each a function of a material and a point of its surface.
namespace framewise::texture {

struct Point {
  float u, v, footprint;
};

// A lattice cell and the place in it, 0 to 1.
struct Cell {
  int i, j;
  float x, y;
};

inline Cell cell_at(float u, float v, float width, float height) {
  const float a = u / width, b = v / height;
  const int i = floor_int(a), j = floor_int(b);
  return {i, j, a - static_cast<float>(i), b - static_cast<float>(j)};
}

// 1 inside an interval, with edges of footprint width.
inline float between(float x, float from, float to, float footprint) {
  return edge(x - from, footprint) * edge(to - x, footprint);
}

inline float inside_rectangle(const Point& p, float u0, float v0, float u1, float v1) {
  return between(p.u, u0, u1, p.footprint) * between(p.v, v0, v1, p.footprint);
}

inline float inside_disc(const Point& p, float u, float v, float radius) {
  return edge(radius - std::sqrt((p.u - u) * (p.u - u) + (p.v - v) * (p.v - v)), p.footprint);
}

// Any colour of a kind, from a number in [0, 1).
inline Color vivid(float h, float lightness) {
  constexpr float kTurn = 6.2831853f;
  return Color{0.52f + 0.44f * std::cos(kTurn * h), 0.46f + 0.38f * std::cos(kTurn * (h - 0.36f)),
               0.42f + 0.38f * std::cos(kTurn * (h - 0.62f))} *
         lightness;
}

inline Color painter(std::uint32_t key, std::uint32_t seed) {
  return vivid(hash01(key, 1, seed), 0.25f + 0.75f * hash01(key, 2, seed));
}

// Darker and lighter around 1.
inline Color shade(const Color& color, float amount) { return color * (amount < -0.9f ? 0.1f : 1 + amount); }

// The part of a footprint around x (both in cells) that lies in inked cells of a row of `count` bits; nothing
// lies before and after them. The footprint is at most one cell.
inline float ink_along(std::uint32_t bits, int count, float x, float footprint) {
  const auto ink = [&](int i) { return i >= 0 && i < count && (bits >> i & 1u) ? 1.0f : 0.0f; };
  const int last = floor_int(x + 0.5f * footprint), first = floor_int(x - 0.5f * footprint);
  if (first == last) return ink(first);
  const float beyond = (x + 0.5f * footprint - static_cast<float>(last)) / footprint;
  return (1 - beyond) * ink(first) + beyond * ink(last);
}

// Ink of made-up letters: each is a hashed pattern of 3 x 5 strokes in a cell, words are broken by blanks.
inline float glyphs(const Point& p, float letter, std::uint32_t seed) {
  constexpr int kAcross = 3, kUp = 5;
  const float seen = visible(0.4f * letter, p.footprint);
  const Cell line = cell_at(p.u, p.v, letter, 1.7f * letter);
  const float x = 4 * line.x, y = 5 * 1.7f * line.y;  // in strokes
  const float across = std::min(1.0f, 4 * p.footprint / letter),
              up = std::min(1.0f, 5 * p.footprint / letter);
  if (x - across > kAcross || y - up > kUp || hash01(line.i, line.j, seed) < 0.17f) return 0;
  if (seen <= 0) return 0.4f;
  const std::uint32_t pattern = hash(line.i, line.j, seed + 1);
  const int row = floor_int(y + 0.5f * up), below = floor_int(y - 0.5f * up);
  const auto ink_of_row = [&](int j) {
    return j >= 0 && j < kUp ? ink_along(pattern >> (kAcross * j), kAcross, x, across) : 0;
  };
  float ink = ink_of_row(row);
  if (below != row) {
    const float above = (y + 0.5f * up - static_cast<float>(row)) / up;
    ink = above * ink + (1 - above) * ink_of_row(below);
  }
  return seen * ink + (1 - seen) * 0.4f;
}

inline float weave(const Point& p, float thread, std::uint32_t seed) {
  const float seen = visible(thread, p.footprint);
  if (seen <= 0) return 0;
  const Cell c = cell_at(p.u, p.v, thread, thread);
  const float over = (c.i + c.j) & 1 ? c.x : c.y;
  return seen * (0.5f - 2 * (over - 0.5f) * (over - 0.5f) + 0.3f * (hash01(c.i, c.j, seed) - 0.5f) - 0.35f);
}

// Light and dark grain along u.
inline float grain(const Point& p, std::uint32_t seed) {
  const float bend = 0.012f * value_noise(p.u * 1.7f, p.v * 9.0f, seed + 40);
  const float fine = fractal_noise(p.u * 0.06f, p.v + bend, 0.022f, 0.72f, p.footprint, seed);
  const float broad = value_noise(p.u * 1.1f, (p.v + bend) * 14.0f, seed + 20);
  const float pores = value_noise(p.u * 9, (p.v + bend) * 270, seed + 30) * visible(0.0037f, p.footprint);
  return 0.55f * fine + 0.35f * broad - 1.2f * std::max(0.0f, pores - 0.45f);
}

// The room itself.
Color paint(const Material& m, const Point& p);
Color plaster(const Material& m, const Point& p);
Color wallpaper(const Material& m, const Point& p);
Color brick(const Material& m, const Point& p);
Color planks(const Material& m, const Point& p);
Color wood(const Material& m, const Point& p);
Color marble(const Material& m, const Point& p);
Color glow(const Material& m, const Point& p);
Color outdoors(const Material& m, const Point& p);

// The ground, and what is built of it.
Color rock(const Material& m, const Point& p);
Color concrete(const Material& m, const Point& p);
Color gravel(const Material& m, const Point& p);
Color patchwork(const Material& m, const Point& p);

// What is woven.
Color carpet(const Material& m, const Point& p);
Color fabric(const Material& m, const Point& p);
Color striped(const Material& m, const Point& p);

// What is printed or painted.
Color spine(const Material& m, const Point& p);
Color pages(const Material& m, const Point& p);
Color framed_print(const Material& m, const Point& p);
Color abstract(const Material& m, const Point& p);
Color landscape(const Material& m, const Point& p);
Color mosaic(const Material& m, const Point& p);
Color carton(const Material& m, const Point& p);

// Small things.
Color checker(const Material& m, const Point& p);
Color ceramic(const Material& m, const Point& p);
Color leaf(const Material& m, const Point& p);
Color fruit(const Material& m, const Point& p);

}  // namespace framewise::texture
