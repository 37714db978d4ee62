// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/texture_kit.h"

namespace framewise::texture {

// Layers of stone, broken along dark cracks, with specks of ore.
Color rock(const Material& m, const Point& p) {
  const float broad = fractal_noise(p.u, p.v, 1.7f, 0.62f, p.footprint, m.seed);
  const float layers = fractal_noise(0.3f * p.u, p.v + 0.12f * broad, 0.22f, 0.66f, p.footprint, m.seed + 20);
  const float fine = fractal_noise(p.u, p.v, 0.05f, 0.8f, p.footprint, m.seed + 60);
  const float crack = std::abs(fractal_noise(p.u, p.v, 0.5f, 0.55f, p.footprint, m.seed + 40));
  const float seen = visible(0.05f, p.footprint);
  const float dark = seen * (1 - smooth(clamp01(9 * crack))) + (1 - seen) * 0.17f;
  const Cell c = cell_at(p.u, p.v, 0.021f, 0.021f);
  const float inside = 0.5f - std::max(std::abs(c.x - 0.5f), std::abs(c.y - 0.5f));
  const float speck = hash01(c.i, c.j, m.seed + 7) < 0.03f
                          ? visible(0.021f, p.footprint) * edge(0.021f * inside, p.footprint)
                          : 0;
  const Color stone = shade(mix(m.a, m.b, clamp01(0.5f + 0.4f * broad + 0.4f * layers)), 0.22f * fine);
  return mix(stone * (1 - 0.7f * dark), {0.75f, 0.72f, 0.6f}, 0.5f * speck);
}

// Cast against boards: joints of panels, tie holes, pores, stains that run down.
Color concrete(const Material& m, const Point& p) {
  constexpr float kWidth = 1.25f, kHeight = 1.25f;
  const Cell c = cell_at(p.u, p.v, kWidth, kHeight);
  const float du = (0.5f - std::abs(c.x - 0.5f)) * kWidth, dv = (0.5f - std::abs(c.y - 0.5f)) * kHeight;
  const float joint = 1 - edge(std::min(du, dv) - 0.006f, p.footprint);
  const float hole = inside_disc({du, dv, p.footprint}, 0.22f, 0.22f, 0.018f);
  const float stains = fractal_noise(p.u, 0.35f * p.v, 0.8f, 0.62f, p.footprint, m.seed);
  const float pores = fractal_noise(p.u, p.v, 0.045f, 0.85f, p.footprint, m.seed + 30);
  const float tone = 0.5f * (hash01(c.i, c.j, m.seed + 3) - 0.5f);
  const Color cast = shade(mix(m.a, m.b, clamp01(0.5f + 0.5f * stains + 0.5f * tone)), 0.13f * pores);
  return cast * (1 - 0.55f * joint) * (1 - 0.6f * hole);
}

// Stones of two sizes, each of its own tone.
Color gravel(const Material& m, const Point& p) {
  float light = 0;
  for (const auto& [size, salt] : {std::pair(0.11f, 1u), std::pair(0.037f, 2u)}) {
    const float bend = 0.3f * size * value_noise(p.u / size, p.v / size, m.seed + 11 * salt);
    const int row = floor_int((p.v + bend) / size);
    const Cell c = cell_at(p.u + bend + 0.5f * size * static_cast<float>(row & 1), p.v + bend, size, size);
    const float x = 2 * c.x - 1, y = 2 * c.y - 1, round = 1.1f - 1.6f * (x * x + y * y) * 0.5f;
    const float tone = hash01(c.i, c.j, m.seed + salt) - 0.5f;
    light += visible(size, p.footprint) * (0.8f * tone + 0.35f * (clamp01(round) - 0.59f));
  }
  const float dirt = fractal_noise(p.u, p.v, 0.9f, 0.7f, p.footprint, m.seed + 50);
  return shade(mix(m.a, m.b, clamp01(0.5f + 0.5f * dirt)), 0.8f * light);
}

// Squares within squares, each of its own colour: something to see from any distance.
Color patchwork(const Material& m, const Point& p) {
  Color color = mix(m.a, m.b, 0.5f);
  float size = 1.9f, turn = 0.3f, strength = 0.34f;
  for (std::uint32_t level = 0; level < 5; ++level, size *= 0.31f, turn += 0.7f, strength *= 0.92f) {
    const float seen = visible(size, p.footprint);
    if (seen <= 0) break;
    const float c = std::cos(turn), s = std::sin(turn);
    const Cell cell = cell_at(c * p.u + s * p.v, c * p.v - s * p.u, size, size);
    // The border between two squares, blurred by the pixel, takes the tone towards their mean.
    const float inside = (0.5f - std::abs(cell.x - 0.5f)) * size,
                above = (0.5f - std::abs(cell.y - 0.5f)) * size;
    const float plain = seen * strength * clamp01(2 * std::min(inside, above) / p.footprint);
    const std::uint32_t key = hash(cell.i, cell.j, m.seed + level);
    const auto tone = [&](std::uint32_t k) { return 2 * (hash01(key, k, m.seed) - 0.5f); };
    color = color * Color{1 + plain * tone(1), 1 + plain * tone(2), 1 + plain * tone(3)};
  }
  return shade(color, 0.1f * fractal_noise(p.u, p.v, 0.02f, 0.8f, p.footprint, m.seed + 9));
}

}  // namespace framewise::texture
