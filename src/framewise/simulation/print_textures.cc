// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <initializer_list>

#include "framewise/simulation/texture_kit.h"

namespace framewise::texture {
namespace {

// White margin and dark frame of everything that hangs on a wall.
Color framed(const Material& m, const Point& p, const Color& picture) {
  const float to_edge = std::min(std::min(p.u, m.width - p.u), std::min(p.v, m.height - p.v));
  const Color mat = shade(srgb(0xe9e4d8), 0.03f * fractal_noise(p.u, p.v, 0.02f, 0.8f, p.footprint, m.seed));
  return mix(mat, picture, edge(to_edge - 0.055f, p.footprint));
}

Color print(const Material& m, const Point& p) {
  const float u = p.u / m.width, v = p.v / m.height;
  Color color = shade(m.a, 0.04f * fractal_noise(p.u, p.v, 0.05f, 0.8f, p.footprint, m.seed));
  const float fw = p.footprint / m.width;
  const float headline =
      glyphs({p.u, p.v - 0.8f * m.height, p.footprint}, 0.1f * m.width, m.seed) * between(v, 0.8f, 0.93f, fw);
  const float text =
      glyphs(p, 0.019f, m.seed + 2) * between(v, 0.1f, 0.36f, fw) * (1 - between(u, 0.48f, 0.52f, fw));
  const float inner = between(u, 0.1f, 0.9f, fw);
  const Cell tile = cell_at(p.u, p.v, 0.13f * m.width, 0.13f * m.width);
  const float disc = edge(
      (0.25f + 0.25f * hash01(tile.i, tile.j, m.seed)) - std::hypot(tile.x - 0.5f, tile.y - 0.5f), fw * 8);
  const Color figure = mix(painter(hash(tile.i, tile.j, m.seed), m.seed),
                           painter(hash(tile.j, tile.i, m.seed + 1), m.seed), disc);
  color = mix(color, figure, inner * between(v, 0.41f, 0.76f, fw));
  return mix(color, m.b, inner * clamp01(headline + text));
}

}  // namespace

// u over the thickness, v up.
Color spine(const Material& m, const Point& p) {
  Color color = shade(m.a, 0.12f * fractal_noise(p.u, p.v, 0.05f, 0.85f, p.footprint, m.seed));
  const float h = m.height;
  const float bands = 0.05f + 0.1f * hash01(1, 0, m.seed);
  for (const float at : {bands, 1 - bands, 0.72f + 0.1f * hash01(2, 0, m.seed)})
    color =
        mix(color, m.b, edge(0.0022f + 0.004f * hash01(3, 0, m.seed) - std::abs(p.v - at * h), p.footprint));
  const float from = (bands + 0.07f) * h, to = 0.68f * h;
  const float letter = std::min(0.45f * m.width, 0.014f);
  const Point along{p.v - from, p.u - 0.5f * (m.width - letter), p.footprint};
  const bool has_label = hash(4, 0, m.seed) & 1u;
  const float label = has_label ? inside_rectangle(p, 0.12f * m.width, from - 0.01f, 0.88f * m.width, to) : 0;
  color = mix(color, m.b, label);
  const float ink = glyphs(along, letter, m.seed) * between(p.v, from, to - 0.01f, p.footprint) *
                    between(along.v, 0, letter, p.footprint);
  return mix(color, has_label ? m.a * 0.4f : m.b, ink);
}

Color pages(const Material& m, const Point& p) {
  const float sheets = value_noise(p.u * 700, p.v * 4, m.seed) * visible(0.0015f, p.footprint);
  return shade(m.a, 0.15f * sheets + 0.06f * fractal_noise(p.u, p.v, 0.03f, 0.7f, p.footprint, m.seed));
}

Color abstract(const Material& m, const Point& p) {
  Color color =
      mix(m.a, m.b, clamp01(0.5f + 0.5f * fractal_noise(p.u, p.v, 0.4f, 0.6f, p.footprint, m.seed)));
  constexpr std::uint32_t kShapes = 22;
  std::array<float, kShapes> across, along, sizes;
  hash01_of_each(kShapes, 11, m.seed, across.data());
  hash01_of_each(kShapes, 12, m.seed, along.data());
  hash01_of_each(kShapes, 13, m.seed, sizes.data());
  for (std::uint32_t k = 0; k < kShapes; ++k) {
    const float u = m.width * across[k], v = m.height * along[k];
    const float size = m.width * (0.03f + 0.16f * sizes[k]);
    if (std::max(std::abs(p.u - u), std::abs(p.v - v)) > size + p.footprint) continue;
    const float mask =
        k % 3 == 0 ? inside_rectangle(p, u - size, v - 0.3f * size, u + size, v + 0.3f * size)
                   : inside_disc(p, u, v, size) - (k % 3 == 1 ? inside_disc(p, u, v, 0.6f * size) : 0);
    if (mask > 0) color = mix(color, painter(k, m.seed), 0.88f * mask);
  }
  return framed(m, p, shade(color, 0.15f * fractal_noise(p.u, p.v, 0.02f, 0.85f, p.footprint, m.seed + 7)));
}

Color landscape(const Material& m, const Point& p) {
  const float v = p.v / m.height;
  Color color = mix(
      m.a, m.b,
      clamp01(1.2f * (v - 0.3f) + 0.25f * fractal_noise(p.u, 2.5f * p.v, 0.3f, 0.6f, p.footprint, m.seed)));
  for (int hill = 0; hill < 5; ++hill) {
    const float crest = 0.72f - 0.13f * hill +
                        0.09f * fractal_noise(p.u, 0.1f * hill, 0.35f, 0.5f, p.footprint, m.seed + hill);
    const Color slope = mix(painter(hill, m.seed), m.a, 0.45f - 0.09f * hill);
    const float trees = fractal_noise(p.u, p.v, 0.05f, 0.85f, p.footprint, m.seed + 20 + hill);
    color = mix(color, shade(slope * 0.7f, 0.35f * trees), edge(crest - v, p.footprint / m.height));
  }
  return framed(m, p, color);
}

Color mosaic(const Material& m, const Point& p) {
  const float size = 0.085f;
  const Cell big = cell_at(p.u, p.v, size, size);
  const bool split = hash01(big.i, big.j, m.seed) < 0.45f;
  const float tile_size = split ? 0.5f * size : size;
  const Cell c = cell_at(p.u, p.v, tile_size, tile_size);
  const float gap = (0.5f - std::max(std::abs(c.x - 0.5f), std::abs(c.y - 0.5f))) * tile_size;
  const Color tile = shade(
      mix(painter(hash(c.i, c.j, m.seed + split), m.seed), mix(m.a, m.b, hash01(c.j, c.i, m.seed)), 0.4f),
      0.12f * fractal_noise(p.u, p.v, 0.03f, 0.85f, p.footprint, m.seed));
  return framed(m, p, mix(m.b * 0.15f, tile, edge(gap - 0.002f, p.footprint)));
}

Color carton(const Material& m, const Point& p) {
  const float fibre = fractal_noise(0.3f * p.u, p.v, 0.04f, 0.85f, p.footprint, m.seed);
  Color color = shade(m.a, 0.13f * fibre);
  color = mix(color, mix(m.a, m.b, 0.6f), 0.8f * between(p.u, 0.46f * m.width, 0.54f * m.width, p.footprint));
  const float u0 = m.width * (0.08f + 0.2f * hash01(1, 1, m.seed)),
              v0 = m.height * (0.15f + 0.25f * hash01(1, 2, m.seed));
  const float u1 = u0 + 0.5f * m.width, v1 = v0 + 0.42f * m.height;
  color = mix(color, m.b, inside_rectangle(p, u0, v0, u1, v1));
  const float ink = glyphs(p, std::min(0.022f, 0.09f * m.width), m.seed) *
                    inside_rectangle(p, u0 + 0.012f, v0 + 0.012f, u1 - 0.012f, v1 - 0.012f);
  return mix(color, m.a * 0.15f, ink);
}

Color framed_print(const Material& m, const Point& p) { return framed(m, p, print(m, p)); }

}  // namespace framewise::texture
