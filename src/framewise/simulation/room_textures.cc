// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/texture_kit.h"

namespace framewise::texture {

Color paint(const Material& m, const Point& p) {
  return shade(m.a, 0.10f * fractal_noise(p.u, p.v, 0.12f, 0.8f, p.footprint, m.seed));
}

Color plaster(const Material& m, const Point& p) {
  const float stains = fractal_noise(p.u, p.v, 0.9f, 0.6f, p.footprint, m.seed);
  const float grit = fractal_noise(p.u, p.v, 0.03f, 0.8f, p.footprint, m.seed + 50);
  return shade(mix(m.a, m.b, clamp01(0.35f + 0.5f * stains)), 0.11f * grit);
}

// Leaf-shaped pairs on stems, no two alike.
Color wallpaper(const Material& m, const Point& p) {
  const Color ground = shade(m.a, 0.07f * fractal_noise(p.u, p.v, 0.4f, 0.8f, p.footprint, m.seed));
  const float row = p.v + 0.02f * value_noise(p.u * 3, p.v * 3, m.seed + 9);
  const Cell c = cell_at(p.u, row, 0.15f, 0.12f);
  const float turn = 6.2831853f * hash01(c.i, c.j, m.seed + 3);
  const float x = (c.x - 0.5f - 0.2f * (hash01(c.i, c.j, m.seed + 5) - 0.5f)) * 0.15f,
              y = (c.y - 0.5f) * 0.12f;
  const float s = x * std::cos(turn) + y * std::sin(turn), t = y * std::cos(turn) - x * std::sin(turn);
  const float length = 0.036f + 0.018f * hash01(c.i, c.j, m.seed + 4);
  const float width = 0.42f * (length - s * s / length) * (0.7f + 0.3f * s / length);
  const float blade = edge(width - std::abs(t), p.footprint) * edge(length - std::abs(s), p.footprint);
  const float vein =
      edge(0.0012f - std::abs(t), p.footprint) +
      0.5f * edge(0.0015f - std::abs(std::fmod(std::abs(s) + std::abs(t) + 1, 0.012f) - 0.006f), p.footprint);
  const Color leaf = shade(mix(m.b, m.a, 0.45f * hash01(c.i, c.j, m.seed + 6)), -0.3f * clamp01(vein));
  return mix(ground, leaf, blade);
}

Color brick(const Material& m, const Point& p) {
  constexpr float kLength = 0.215f, kHeight = 0.07f, kJoint = 0.006f;
  const int row = floor_int(p.v / kHeight);
  const float wobble = 0.0025f * value_noise(p.u * 40, p.v * 40, m.seed + 2);
  const Cell c = cell_at(p.u + (row & 1 ? 0.5f * kLength : 0), p.v, kLength, kHeight);
  const float du = (0.5f - std::abs(c.x - 0.5f)) * kLength, dv = (0.5f - std::abs(c.y - 0.5f)) * kHeight;
  const float face = edge(du - kJoint + wobble, p.footprint) * edge(dv - kJoint + wobble, p.footprint);
  const float rough = fractal_noise(p.u, p.v, 0.06f, 0.8f, p.footprint, m.seed);
  const Color fired = shade(mix(m.a, m.b, hash01(c.i, c.j, m.seed)),
                            0.25f * rough + 0.3f * (hash01(c.i, c.j, m.seed + 1) - 0.5f));
  const Color mortar = shade(srgb(0xb9b0a2), 0.15f * rough);
  return mix(mortar, fired, face);
}

Color planks(const Material& m, const Point& p) {
  constexpr float kWidth = 0.11f, kLength = 1.25f;
  const int row = floor_int(p.v / kWidth);
  const Cell c = cell_at(p.u + kLength * hash01(row, 7, m.seed), p.v, kLength, kWidth);
  const std::uint32_t board = hash(c.i, c.j, m.seed);
  const Point shifted{p.u + (board & 63u), p.v, p.footprint};
  const float gap = std::min((0.5f - std::abs(c.x - 0.5f)) * kLength, (0.5f - std::abs(c.y - 0.5f)) * kWidth);
  const float tint = hash01(c.i, c.j, m.seed + 1);
  const Color board_color = shade(mix(m.a, m.b, tint), 0.30f * grain(shifted, m.seed + (board & 1023u)));
  return board_color * (0.3f + 0.7f * edge(gap - 0.0012f, p.footprint));
}

Color wood(const Material& m, const Point& p) {
  const float g = grain(p, m.seed);
  return shade(mix(m.a, m.b, clamp01(0.5f + 0.6f * g)),
               0.1f * fractal_noise(p.u, p.v, 0.01f, 0.8f, p.footprint, m.seed + 8));
}

Color marble(const Material& m, const Point& p) {
  const float warp = fractal_noise(p.u, p.v, 0.25f, 0.6f, p.footprint, m.seed);
  const float vein = std::abs(fractal_noise(p.u + 0.1f * warp, p.v, 0.12f, 0.65f, p.footprint, m.seed + 30));
  return shade(mix(m.b, m.a, smooth(clamp01(6 * vein))), 0.06f * warp);
}

Color glow(const Material& m, const Point& p) {
  const float v = p.v / m.height;
  const float pleat = 0.06f * std::cos(p.u * 420) * visible(0.015f, p.footprint);
  return shade(mix(m.b, m.a, smooth(clamp01(1 - 1.6f * std::abs(v - 0.45f)))),
               pleat + 0.08f * fractal_noise(p.u, p.v, 0.05f, 0.8f, p.footprint, m.seed));
}

Color outdoors(const Material& m, const Point& p) {
  const float v = p.v / m.height;
  const float cloud = clamp01(0.1f + 0.7f * fractal_noise(p.u, 2.2f * p.v, 0.5f, 0.55f, p.footprint, m.seed));
  Color color = mix(mix(m.a * 1.15f, m.a * 0.8f, v), srgb(0xffffff), cloud);
  const float far_hill = 0.42f + 0.07f * fractal_noise(p.u, 0, 0.7f, 0.45f, p.footprint, m.seed + 1);
  const float trees = 0.25f + 0.10f * fractal_noise(p.u, 0.3f, 0.28f, 0.65f, p.footprint, m.seed + 2);
  const float foliage = fractal_noise(p.u, p.v, 0.07f, 0.85f, p.footprint, m.seed + 3);
  color = mix(color, mix(m.b, m.a, 0.45f), edge(far_hill - v, 0.02f));
  return mix(color, shade(m.b * 0.6f, 0.6f * foliage), edge(trees + 0.03f * foliage - v, 0.015f));
}

}  // namespace framewise::texture
