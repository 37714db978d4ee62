// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/sphere_field_scene.h"

#include "framewise/simulation/light_baking.h"
#include "framewise/simulation/mesh_builder.h"
#include "framewise/simulation/random.h"

namespace framewise {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kHalfSide = 6.5f, kCeiling = 8;
constexpr int kBalls = 220;

void hall(MeshBuilder& builder, Random& random) {
  const Vector3f corner(-kHalfSide, -kHalfSide, 0), x(2 * kHalfSide, 0, 0), y(0, 2 * kHalfSide, 0),
      z(0, 0, kCeiling);
  const auto wall = [&](std::uint32_t a, std::uint32_t b) {
    return Material{Texture::kPatchwork, srgb(a), srgb(b), random.seed()};
  };
  builder.set_cell_factor(10);
  builder.quad(corner, x, y, wall(0xb09a78, 0x8a8478));
  builder.quad(corner + z + y, x, -y, wall(0xd8d4c8, 0xc0c4cc));
  builder.quad(corner + x, -x, z, wall(0x9ab0b8, 0xb8c0a8));
  builder.quad(corner + y, x, z, wall(0xc0a898, 0xa8a0b0));
  builder.quad(corner, y, z, wall(0xa8b898, 0xc0b090));
  builder.quad(corner + x + y, -y, z, wall(0xb8a8b8, 0x98a8b8));
}

Material skin(Random& random) {
  constexpr Texture kKinds[] = {Texture::kCeramic, Texture::kMarble, Texture::kPatchwork,
                                Texture::kMosaic,  Texture::kBrick,  Texture::kRock};
  constexpr std::uint32_t kColors[] = {0xc0503a, 0x3a6ea0, 0x4a8a4a, 0xd0a030, 0x8a4a7a,
                                       0xe0d8c0, 0x404850, 0xd07840, 0x50a0a0, 0xa0b040};
  const Texture kind = kKinds[random.below(6)];
  const Color a = srgb(kColors[random.below(10)]), b = srgb(kColors[random.below(10)]);
  return {kind, a, b, random.seed()};
}

}  // namespace

PathSpace sphere_field_space() {
  const Eigen::AlignedBox3d box{Vector3d(-2, -1.5, 3.3), Vector3d(2, 1.5, 4.5)};
  return {box, -4 * M_PI / 180, round_way(box)};
}

Scene sphere_field_scene(const SceneOptions& options) {
  Scene scene;
  MeshBuilder builder(scene, options.light_cell);
  Random random(options.seed ^ 0x5370686572657300u);
  hall(builder, random);
  builder.set_cell_factor(2);
  const Eigen::AlignedBox3f free_space = sphere_field_space().free_space.cast<float>();
  for (int placed = 0; placed < kBalls;) {
    const auto uniform = [&](float from, float to) { return static_cast<float>(random.uniform(from, to)); };
    const float radius = 0.12f + 0.5f * std::pow(uniform(0, 1), 2.0f);
    const float x = uniform(-kHalfSide, kHalfSide), y = uniform(-kHalfSide, kHalfSide),
                z = uniform(0, kCeiling);
    if (free_space.exteriorDistance(Vector3f(x, y, z)) < radius + 0.5f) continue;
    builder.sphere({x, y, z}, radius, skin(random));
    ++placed;
  }
  scene.lights = {{{-5, 5, kCeiling - 0.01f}, {10, 0, 0}, {0, -10, 0}, Color{2.3f, 2.26f, 2.15f}},
                  {{-kHalfSide + 0.01f, -3, 1}, {0, 6, 0}, {0, 0, 5}, Color{1.2f, 1.3f, 1.45f}}};
  if (options.lit) bake_light(scene);
  return scene;
}

}  // namespace framewise
