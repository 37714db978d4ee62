// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <initializer_list>

#include "framewise/simulation/texture_kit.h"

namespace framewise::texture {
namespace {

Color motif(const Material& m, const Cell& c, float size, float footprint, std::uint32_t seed) {
  const float x = std::abs(c.x - 0.5f), y = std::abs(c.y - 0.5f);
  const float distance = (hash(c.i, c.j, seed) & 1u ? x + y : 1.3f * std::max(x, y)) * size;
  Color color = mix(m.a, m.b, 0.12f);
  for (int ring = 0; ring < 4; ++ring) {
    const float radius = size * (0.52f - 0.13f * ring);
    color = mix(color, mix(painter(hash(c.i, c.j, seed) + ring, seed) * 0.6f, ring & 1 ? m.b : m.a, 0.55f),
                edge(radius - distance, footprint));
  }
  return color;
}

}  // namespace

Color carpet(const Material& m, const Point& p) {
  const float to_edge = std::min(std::min(p.u, m.width - p.u), std::min(p.v, m.height - p.v));
  const float size = to_edge < 0.30f ? 0.1f : 0.19f;
  Color color =
      motif(m, cell_at(p.u, p.v, size, size), size, p.footprint, m.seed + (to_edge < 0.30f ? 1 : 0));
  for (const float line : {0.05f, 0.075f, 0.30f, 0.33f})
    color = mix(color, line < 0.06f || line > 0.32f ? m.b : m.a * 0.4f,
                edge(0.009f - std::abs(to_edge - line), p.footprint));
  const float wear = fractal_noise(p.u, p.v, 0.15f, 0.85f, p.footprint, m.seed + 4);
  return shade(color, 0.2f * wear + 0.5f * weave(p, 0.004f, m.seed));
}

Color fabric(const Material& m, const Point& p) {
  const float mottle = fractal_noise(p.u, p.v, 0.08f, 0.85f, p.footprint, m.seed);
  return shade(mix(m.a, m.b, clamp01(0.3f + 0.4f * mottle)), 0.6f * weave(p, 0.005f, m.seed));
}

Color striped(const Material& m, const Point& p) {
  const Cell c = cell_at(p.u, p.v, 0.09f, 0.09f);
  const float band = between(c.x, 0.1f, 0.28f + 0.3f * hash01(c.i, 0, m.seed), p.footprint / 0.09f);
  const float cross = 0.7f * between(c.y, 0.55f, 0.65f + 0.3f * hash01(c.j, 1, m.seed), p.footprint / 0.09f);
  const Color color = mix(m.a, m.b, clamp01(band + cross - band * cross));
  return shade(color, 0.12f * fractal_noise(p.u, p.v, 0.05f, 0.85f, p.footprint, m.seed) +
                          0.6f * weave(p, 0.004f, m.seed));
}

}  // namespace framewise::texture
