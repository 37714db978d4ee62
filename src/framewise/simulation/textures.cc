// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/textures.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "framewise/simulation/noise.h"

namespace framewise {
namespace {

struct Point {
  float u, v, footprint;
};

// A lattice cell and the place in it, 0 to 1.
struct Cell {
  int i, j;
  float x, y;
};

Cell cell_at(float u, float v, float width, float height) {
  const float a = u / width, b = v / height;
  const int i = floor_int(a), j = floor_int(b);
  return {i, j, a - static_cast<float>(i), b - static_cast<float>(j)};
}

// 1 inside an interval, with edges of footprint width.
float between(float x, float from, float to, float footprint) {
  return edge(x - from, footprint) * edge(to - x, footprint);
}

float inside_rectangle(const Point& p, float u0, float v0, float u1, float v1) {
  return between(p.u, u0, u1, p.footprint) * between(p.v, v0, v1, p.footprint);
}

float inside_disc(const Point& p, float u, float v, float radius) {
  return edge(radius - std::sqrt((p.u - u) * (p.u - u) + (p.v - v) * (p.v - v)), p.footprint);
}

// Any colour of a kind, from a number in [0, 1).
Color vivid(float h, float lightness) {
  constexpr float kTurn = 6.2831853f;
  return Color{0.52f + 0.44f * std::cos(kTurn * h), 0.46f + 0.38f * std::cos(kTurn * (h - 0.36f)),
               0.42f + 0.38f * std::cos(kTurn * (h - 0.62f))} *
         lightness;
}

Color painter(std::uint32_t key, std::uint32_t seed) {
  return vivid(hash01(key, 1, seed), 0.25f + 0.75f * hash01(key, 2, seed));
}

// Darker and lighter around 1.
Color shade(const Color& color, float amount) { return color * (amount < -0.9f ? 0.1f : 1 + amount); }

// Ink of made-up letters: each is a hashed pattern of 3 x 5 strokes in a cell, words are broken by blanks.
float glyphs(const Point& p, float letter, std::uint32_t seed) {
  const Cell line = cell_at(p.u, p.v, letter, 1.7f * letter);
  const float y = line.y * 1.7f;
  if (y > 1 || hash01(line.i, line.j, seed) < 0.17f) return 0;
  const Cell stroke = cell_at(line.x, y, 0.25f, 0.2f);
  if (stroke.i > 2) return 0;
  const std::uint32_t pattern = hash(line.i, line.j, seed + 1);
  const float ink = (pattern >> (stroke.i + 3 * stroke.j)) & 1u ? 1.0f : 0.0f;
  const float seen = visible(0.4f * letter, p.footprint);
  return seen * ink + (1 - seen) * 0.4f;
}

float weave(const Point& p, float thread, std::uint32_t seed) {
  const float seen = visible(thread, p.footprint);
  if (seen <= 0) return 0;
  const Cell c = cell_at(p.u, p.v, thread, thread);
  const float over = (c.i + c.j) & 1 ? c.x : c.y;
  return seen * (0.5f - 2 * (over - 0.5f) * (over - 0.5f) + 0.3f * (hash01(c.i, c.j, seed) - 0.5f) - 0.35f);
}

// Light and dark grain along u.
float grain(const Point& p, std::uint32_t seed) {
  const float bend = 0.012f * value_noise(p.u * 1.7f, p.v * 9.0f, seed + 40);
  const float fine = fractal_noise(p.u * 0.06f, p.v + bend, 0.022f, 0.72f, p.footprint, seed);
  const float broad = value_noise(p.u * 1.1f, (p.v + bend) * 14.0f, seed + 20);
  return 0.55f * fine + 0.35f * broad;
}

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

Color checker(const Material& m, const Point& p) {
  constexpr float kSquare = 0.045f;
  const float margin = 0.5f * (m.width - 8 * kSquare);
  const float board = inside_rectangle(p, margin, margin, m.width - margin, m.height - margin);
  const Cell c = cell_at(p.u - margin, p.v - margin, kSquare, kSquare);
  const Point local{p.u, (c.i + c.j) & 1 ? p.v : -p.v, p.footprint};
  const float g = 0.25f * grain(local, m.seed + hash(c.i, c.j, m.seed) % 97);
  return shade(mix(m.b * 0.6f, (c.i + c.j) & 1 ? m.a : m.b, board), g);
}

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

Color abstract(const Material& m, const Point& p) {
  Color color =
      mix(m.a, m.b, clamp01(0.5f + 0.5f * fractal_noise(p.u, p.v, 0.4f, 0.6f, p.footprint, m.seed)));
  for (std::uint32_t k = 0; k < 22; ++k) {
    const float u = m.width * hash01(k, 11, m.seed), v = m.height * hash01(k, 12, m.seed);
    const float size = m.width * (0.03f + 0.16f * hash01(k, 13, m.seed));
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

Color marble(const Material& m, const Point& p) {
  const float warp = fractal_noise(p.u, p.v, 0.25f, 0.6f, p.footprint, m.seed);
  const float vein = std::abs(fractal_noise(p.u + 0.1f * warp, p.v, 0.12f, 0.65f, p.footprint, m.seed + 30));
  return shade(mix(m.b, m.a, smooth(clamp01(6 * vein))), 0.06f * warp);
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

}  // namespace

Color albedo(const Material& m, float u, float v, float footprint) {
  const Point p{u, v, footprint};
  switch (m.texture) {
    case Texture::paint:
      return paint(m, p);
    case Texture::plaster:
      return plaster(m, p);
    case Texture::wallpaper:
      return wallpaper(m, p);
    case Texture::brick:
      return brick(m, p);
    case Texture::planks:
      return planks(m, p);
    case Texture::wood:
      return wood(m, p);
    case Texture::carpet:
      return carpet(m, p);
    case Texture::fabric:
      return fabric(m, p);
    case Texture::striped:
      return striped(m, p);
    case Texture::checker:
      return checker(m, p);
    case Texture::spine:
      return spine(m, p);
    case Texture::pages:
      return pages(m, p);
    case Texture::print:
      return framed(m, p, print(m, p));
    case Texture::abstract:
      return abstract(m, p);
    case Texture::landscape:
      return landscape(m, p);
    case Texture::mosaic:
      return mosaic(m, p);
    case Texture::carton:
      return carton(m, p);
    case Texture::ceramic:
      return ceramic(m, p);
    case Texture::marble:
      return marble(m, p);
    case Texture::leaf:
      return leaf(m, p);
    case Texture::fruit:
      return fruit(m, p);
    case Texture::glow:
      return glow(m, p);
    case Texture::outdoors:
      return outdoors(m, p);
  }
  return {};
}

}  // namespace framewise
