// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/texture_kit.h"

namespace framewise::texture {

Color checker(const Material& m, const Point& p) {
  constexpr float kSquare = 0.045f;
  const float margin = 0.5f * (m.width - 8 * kSquare);
  const float board = inside_rectangle(p, margin, margin, m.width - margin, m.height - margin);
  const Cell c = cell_at(p.u - margin, p.v - margin, kSquare, kSquare);
  const Point local{p.u, (c.i + c.j) & 1 ? p.v : -p.v, p.footprint};
  const float g = 0.25f * grain(local, m.seed + hash(c.i, c.j, m.seed) % 97);
  const float inside = (0.5f - std::max(std::abs(c.x - 0.5f), std::abs(c.y - 0.5f))) * kSquare;
  const float own = edge(inside, p.footprint);  // a half on the border
  const Color square = (c.i + c.j) & 1 ? mix(m.b, m.a, own) : mix(m.a, m.b, own);
  return shade(mix(m.b * 0.6f, square, board), g);
}

Color ceramic(const Material& m, const Point& p) {
  const float wave = 0.006f * std::sin(p.u * 90) * (hash(9, 9, m.seed) & 1u ? 1.0f : 0.0f);
  const Cell c = cell_at(p.u, p.v + wave, 0.035f, 0.028f);
  const std::uint32_t style = hash(c.j, 3, m.seed) % 4;
  const float rim = edge(0.0028f - (0.5f - std::abs(c.y - 0.5f)) * 0.028f, p.footprint);
  const float dots =
      style == 1 ? edge(0.008f - std::hypot((c.x - 0.5f) * 0.035f, (c.y - 0.5f) * 0.028f), p.footprint) : 0;
  const Color band = style == 2 ? m.b : (style == 3 ? mix(m.a, m.b, 0.5f) : m.a);
  const Color color = mix(mix(band, m.b, dots), m.b * 0.5f, rim);
  return shade(color, 0.12f * fractal_noise(p.u, p.v, 0.05f, 0.8f, p.footprint, m.seed));
}

// u across, v from stem to tip.
Color leaf(const Material& m, const Point& p) {
  const float rib = edge(0.002f - std::abs(p.u), p.footprint);
  const float side = std::abs(std::fmod(p.v + std::abs(p.u), 0.018f) - 0.009f);
  const float veins = edge(0.0012f - side, p.footprint) * visible(0.009f, p.footprint);
  const Color green = shade(m.a, 0.2f * fractal_noise(p.u, p.v, 0.04f, 0.8f, p.footprint, m.seed));
  return mix(green, m.b, clamp01(0.8f * rib + 0.5f * veins));
}

Color fruit(const Material& m, const Point& p) {
  const float blush = fractal_noise(p.u, p.v, 0.09f, 0.6f, p.footprint, m.seed);
  const float speckle = fractal_noise(p.u, p.v, 0.006f, 0.7f, p.footprint, m.seed + 5);
  return shade(mix(m.a, m.b, clamp01(0.4f + 0.7f * blush)), 0.25f * speckle);
}

}  // namespace framewise::texture
