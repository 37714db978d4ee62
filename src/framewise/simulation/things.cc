// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/things.h"

#include <algorithm>
#include <cmath>

namespace framewise {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

float uniform(Random& random, double from, double to) { return static_cast<float>(random.uniform(from, to)); }

constexpr std::uint32_t kCloth[] = {0x8c2f2b, 0x1f3f66, 0x2e5b3c, 0xc9a227, 0x59324f, 0xd9d2bf,
                                    0x20242b, 0xb5602c, 0x3f7f8a, 0x7a1f3a, 0xe0b9a0, 0x4b5a2a,
                                    0x9aa7b0, 0x6a4a30, 0xd35f4b, 0x2b6e9e};
constexpr std::uint32_t kGilt[] = {0xe8cf8a, 0xf2ead6, 0xd8d8d8, 0x1c1c22, 0xf0d060};

Color one_of(Random& random, std::span<const std::uint32_t> colors) {
  return srgb(colors[random.below(static_cast<int>(colors.size()))]);
}

// A book by its size with the spine towards -y, or lying with the spine towards -y.
void book(MeshBuilder& builder, Random& random, const Vector3f& corner, const Vector3f& size, bool lying) {
  const Material cover{Texture::kPaint, one_of(random, kCloth), {}, random.seed()};
  Material back = cover;
  back.texture = Texture::kSpine;
  back.b = one_of(random, kGilt);
  const Material paper{Texture::kPages, srgb(0xe6dcc2), {}, random.seed()};
  Material title = back;
  title.texture = Texture::kCarton;
  title.a = cover.a;
  if (lying)
    builder.box(corner, size, {back, paper, paper, paper, title, cover});
  else
    builder.box(corner, size, {back, paper, cover, cover, paper, cover});
}

}  // namespace

void vase(MeshBuilder& builder, Random& random, const Vector3f& at, float height) {
  const float belly = uniform(random, 0.2, 0.3), neck = uniform(random, 0.07, 0.12),
              at_belly = uniform(random, 0.3, 0.5);
  std::vector<Vector2f> profile{{0, 0}};
  for (int i = 0; i <= 20; ++i) {
    const float t = static_cast<float>(i) / 20;
    const float bulge = std::exp(-12 * (t - at_belly) * (t - at_belly)),
                lip = 0.1f * std::exp(-200 * (t - 1) * (t - 1));
    profile.push_back({height * (neck + (belly - neck) * bulge + lip), height * t});
  }
  const Material glaze{Texture::kCeramic, one_of(random, kCloth), one_of(random, kGilt), random.seed()};
  builder.lathe(at, profile, glaze);
}

void fruit_bowl(MeshBuilder& builder, Random& random, const Vector3f& at) {
  const Material glaze{Texture::kCeramic, srgb(0xe9e2d0), srgb(0x2f5f8f), random.seed()};
  const Vector2f profile[] = {{0, 0},          {0.06f, 0},      {0.07f, 0.01f},
                              {0.12f, 0.04f},  {0.15f, 0.075f}, {0.146f, 0.077f},
                              {0.11f, 0.045f}, {0.05f, 0.022f}, {0, 0.02f}};
  builder.lathe(at, profile, glaze);
  const std::uint32_t ripe[] = {0xc23b22, 0xe08a1e, 0x8aa63a, 0xd9b32a, 0xa82a3a};
  for (int i = 0; i < 6; ++i) {
    const float angle = 2 * static_cast<float>(M_PI) * static_cast<float>(i) / 5, out = i < 5 ? 0.075f : 0.0f;
    const Material skin{Texture::kFruit, srgb(ripe[i % 5]), srgb(ripe[(i + 1) % 5]), random.seed()};
    builder.sphere(at + Vector3f(out * std::cos(angle), out * std::sin(angle), i < 5 ? 0.068f : 0.098f),
                   0.038f, skin);
  }
}

void book_pile(MeshBuilder& builder, Random& random, const Vector3f& at, int count) {
  float z = 0;
  for (int i = 0; i < count; ++i) {
    const Vector3f size(uniform(random, 0.17, 0.24), uniform(random, 0.13, 0.17),
                        uniform(random, 0.015, 0.04));
    book(builder, random,
         at + Vector3f(-0.5f * size.x() + uniform(random, -0.015, 0.015), -0.5f * size.y(), z), size, true);
    z += size.z();
  }
}

void mug(MeshBuilder& builder, Random& random, const Vector3f& at) {
  const Material glaze{Texture::kCeramic, one_of(random, kCloth), one_of(random, kGilt), random.seed()};
  const Vector2f profile[] = {{0, 0},          {0.038f, 0},      {0.04f, 0.003f},  {0.041f, 0.03f},
                              {0.041f, 0.06f}, {0.041f, 0.095f}, {0.037f, 0.095f}, {0.036f, 0.085f}};
  builder.lathe(at, profile, glaze);
  builder.cylinder(at + Vector3f(0, 0, 0.07f), 0.0365f, 0.012f,
                   {Texture::kFruit, srgb(0x3b2415), srgb(0x5a3a22), random.seed()});
}

void ball(MeshBuilder& builder, Random& random, const Vector3f& at, float radius) {
  const Material pattern{random.below(2) ? Texture::kCeramic : Texture::kMarble, one_of(random, kCloth),
                         one_of(random, kGilt), random.seed()};
  builder.sphere(at + Vector3f(0, 0, radius), radius, pattern);
}

void carton(MeshBuilder& builder, Random& random, const Vector3f& at, float size) {
  const Material board{Texture::kCarton, srgb(0xb48a5a), srgb(0xf0ece0), random.seed()};
  const Vector3f extent(size, 0.8f * size, uniform(random, 0.55, 0.9) * size);
  builder.box(at - Vector3f(0.5f * extent.x(), 0.5f * extent.y(), 0), extent, board);
}

void chess_board(MeshBuilder& builder, Random& random, const Vector3f& at) {
  const Material squares{Texture::kChecker, srgb(0x4a2d1b), srgb(0xdcb98a), random.seed(), 0.4f, 0.4f};
  const Material rim{Texture::kWood, srgb(0x4a2d1b), srgb(0x6f4a2c), random.seed()};
  builder.box(at - Vector3f(0.2f, 0.2f, 0), {0.4f, 0.4f, 0.018f}, {rim, rim, rim, rim, squares, rim});
  for (int k = 0; k < 14; ++k) {
    const bool white = k % 2;
    const Material turned{Texture::kWood, srgb(white ? 0xd8b888 : 0x2b1a10),
                          srgb(white ? 0xf2dcb4 : 0x4a3020), random.seed()};
    const float tall = uniform(random, 0.035, 0.07);
    const Vector2f profile[] = {{0, 0},
                                {0.014f, 0},
                                {0.014f, 0.006f},
                                {0.007f, 0.4f * tall},
                                {0.006f, 0.7f * tall},
                                {0.011f, 0.8f * tall},
                                {0.009f, 0.95f * tall},
                                {0, tall}};
    const int file = random.below(8), rank = (white ? 0 : 4) + random.below(4);
    builder.lathe(at + Vector3f(0.045f * (static_cast<float>(file) - 3.5f),
                                0.045f * (static_cast<float>(rank) - 3.5f), 0.018f),
                  profile, turned);
  }
}

void plant(MeshBuilder& builder, Random& random, const Vector3f& at, float height) {
  const float pot = 0.24f * height;
  const Material clay{Texture::kCeramic, srgb(0xb0603a), srgb(0xd9a070), random.seed()};
  const Vector2f profile[] = {{0, 0},
                              {0.55f * pot, 0},
                              {0.6f * pot, 0.3f * pot},
                              {0.66f * pot, 0.7f * pot},
                              {0.72f * pot, pot},
                              {0.66f * pot, pot},
                              {0.6f * pot, 0.9f * pot},
                              {0, 0.9f * pot}};
  builder.lathe(at, profile, clay);
  const int leaves = 42;
  for (int k = 0; k < leaves; ++k) {
    const Material green{Texture::kLeaf, mix(srgb(0x2f6b2f), srgb(0x7da843), uniform(random, 0, 1)),
                         srgb(0xb9d38a), random.seed()};
    const float heading = 2.4f * static_cast<float>(k), rise = 0.25f + 0.75f * static_cast<float>(k) / leaves;
    const float length = height * uniform(random, 0.28, 0.42), width = 0.3f * length;
    const Vector3f out(std::cos(heading), std::sin(heading), 0),
        side(-std::sin(heading), std::cos(heading), 0);
    const Vector3f root =
        at + Vector3f(0, 0, pot * 0.9f + (height - pot) * rise * 0.62f) + 0.03f * height * out;
    const float lift = 0.35f + 0.75f * rise;
    builder.sheet(5, 9, true, green, [&](float s, float t) {
      const float half = width * std::sin(static_cast<float>(M_PI) * std::pow(t, 0.75f)) * 0.5f + 0.003f,
                  across = 2 * s - 1;
      const Vector3f spine = root + length * (t * 0.9f * out + Vector3f(0, 0, lift * t - 0.75f * t * t));
      return Vertex{spine + half * across * side + Vector3f(0, 0, 0.25f * half * across * across),
                    {},
                    {half * across, t * length},
                    {}};
    });
  }
  builder.cylinder(at + Vector3f(0, 0, 0.85f * pot), 0.02f * height, 0.7f * (height - pot),
                   {Texture::kWood, srgb(0x4f5a2a), srgb(0x7a7a40), random.seed()});
}

void row_of_things(MeshBuilder& builder, Random& random, const Vector3f& back_left, float width, float height,
                   float depth) {
  float x = 0.01f;
  while (x < width - 0.05f) {
    const Vector3f at = back_left + Vector3f(x, 0, 0);
    const float kind = uniform(random, 0, 1), room = width - x;
    const float middle = std::min(0.11f, 0.5f * depth);
    if (kind < 0.05f && room > 0.3f) {
      vase(builder, random, at + Vector3f(middle, -0.5f * depth, 0), 0.85f * std::min(height, 2.6f * middle));
      x += 2 * middle + 0.02f;
    } else if (kind < 0.09f && room > 0.3f) {
      carton(builder, random, at + Vector3f(0.12f, -0.5f * depth, 0), std::min(0.22f, 1.1f * depth));
      x += 0.25f;
    } else if (kind < 0.12f && room > 0.3f) {
      ball(builder, random, at + Vector3f(middle, -0.55f * depth, 0), 0.8f * middle);
      x += 2 * middle;
    } else {
      const float thick = uniform(random, 0.016, 0.05), tall = height * uniform(random, 0.66, 0.97),
                  deep = depth * uniform(random, 0.7, 0.98);
      book(builder, random, at - Vector3f(0, deep, 0), {thick, deep, tall}, false);
      x += thick + 0.0015f;
    }
  }
}

}  // namespace framewise
