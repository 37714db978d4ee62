// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/corridor_scene.h"

#include "framewise/simulation/furniture.h"
#include "framewise/simulation/light_baking.h"

namespace framewise {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kBays = 15;
constexpr float kBay = 4, kCorridorLength = kBays * kBay, kHalfWidth = 1.2f, kCorridorHeight = 2.6f;
constexpr float kHalfTurn = static_cast<float>(M_PI);

// A door in the wall behind, as wide as 0.95 m, with its frame and sign.
void door(MeshBuilder& builder, Random& random, float at) {
  const Material leaf = wood_of(random, srgb(0x8a5a34), srgb(0xb98a54)),
                 frame{Texture::kPaint, srgb(0x5a6068), {}, random.seed()},
                 sign{Texture::kPrint, srgb(0xe8e8e0), srgb(0x20242c), random.seed()};
  builder.box({at - 0.475f, -0.02f, 0.01f}, {0.95f, 0.02f, 2.05f}, leaf);
  for (const float x : {-0.545f, 0.475f}) builder.box({at + x, -0.05f, 0}, {0.07f, 0.05f, 2.13f}, frame);
  builder.box({at - 0.475f, -0.05f, 2.06f}, {0.95f, 0.05f, 0.07f}, frame);
  builder.box({at + 0.34f, -0.07f, 1.02f}, {0.1f, 0.05f, 0.025f}, frame);
  builder.box({at + 0.62f, -0.01f, 1.45f}, {0.21f, 0.01f, 0.15f}, sign);
}

// One side of a bay. Every bay begins with the same random numbers.
void side(MeshBuilder& builder, std::uint64_t seed) {
  Random random(seed);
  const Material plaster{Texture::kPlaster, srgb(0xd8d0bc), srgb(0xc8bca0), random.seed()},
      panel{Texture::kConcrete, srgb(0x8898a0), srgb(0x707c88), random.seed()},
      rail = wood_of(random, srgb(0x6a4a30), srgb(0x8a6a48));
  builder.set_cell_factor(4);
  builder.quad({0, 0, 1.0f}, {kBay, 0, 0}, {0, 0, kCorridorHeight - 1.0f}, plaster);
  builder.quad({0, 0, 0}, {kBay, 0, 0}, {0, 0, 1.0f}, panel);
  builder.set_cell_factor(2);
  door(builder, random, 0.9f);
  builder.box({1.6f, -0.04f, 0.96f}, {kBay - 1.6f, 0.04f, 0.1f}, rail);
  const float turn = builder.turn();
  const Vector3f board = builder.to_world({2.7f, 0, 1.62f});
  const Vector3f shelf = builder.to_world({0, 0, 0});
  builder.place(board, turn);
  wall_board(builder, random, 1.1f);
  builder.place(shelf, turn);
  const Material red{Texture::kPaint, srgb(0xb02018), {}, random.seed()};
  builder.cylinder({3.7f, -0.1f, 0.35f}, 0.07f, 0.5f, red);
}

void floor_and_ceiling(MeshBuilder& builder, Random& random) {
  builder.place({0, 0, 0});
  builder.set_cell_factor(5);
  const Vector3f corner(0, -kHalfWidth, 0), x(kCorridorLength, 0, 0), y(0, 2 * kHalfWidth, 0),
      z(0, 0, kCorridorHeight);
  builder.quad(corner, x, y, {Texture::kPlanks, srgb(0x8a8478), srgb(0xa8a290), random.seed()});
  builder.quad(corner + z + y, x, -y, {Texture::kConcrete, srgb(0xe0dcd0), srgb(0xd0ccc0), random.seed()});
  const Material ends{Texture::kPlaster, srgb(0xb8a890), srgb(0xa89478), random.seed()};
  builder.quad(corner, y, z, ends);
  builder.quad(corner + x + y, -y, z, ends);
  builder.place({0, 0, 1.6f}, 0.5f * kHalfTurn);
  wall_board(builder, random, 1.2f);
  builder.place({kCorridorLength, 0, 1.6f}, -0.5f * kHalfTurn);
  wall_board(builder, random, 0.9f);
}

void lamp(Scene& scene, MeshBuilder& builder, float x) {
  const float below = kCorridorHeight - 0.07f;
  Material shade{Texture::kGlow, srgb(0xfff8e8), srgb(0xe8e0c8), 5, 1.2f, 0.3f};
  shade.emission = 1.1f;
  builder.place({x, 0, 0});
  builder.set_cell_factor(4);
  builder.box({-0.6f, -0.15f, below}, {1.2f, 0.3f, 0.069f}, shade);
  scene.lights.push_back({{x - 0.6f, 0.15f, below - 0.005f}, {1.2f, 0, 0}, {0, -0.3f, 0}, Color{17, 16, 14}});
}

}  // namespace

Scene corridor_scene(const SceneOptions& options) {
  Scene scene;
  MeshBuilder builder(scene, options.light_cell);
  Random random(options.seed ^ 0x436f7272696400u);
  const std::uint64_t left = random.bits(), right = random.bits();
  floor_and_ceiling(builder, random);
  for (int bay = 0; bay < kBays; ++bay) {
    const float x = kBay * static_cast<float>(bay);
    builder.place({x, kHalfWidth, 0}, 0);
    side(builder, left);
    builder.place({x + kBay, -kHalfWidth, 0}, kHalfTurn);
    side(builder, right);
    lamp(scene, builder, x + 0.5f * kBay);
  }
  if (options.lit) bake_light(scene);
  return scene;
}

PathSpace corridor_space() {
  PathSpace space{{Vector3d(25, -0.45, 1.3), Vector3d(33, 0.45, 1.8)}, -4 * M_PI / 180, {}};
  constexpr double kAside = 0.4, kEnd = 3, kEye = 1.55;
  const double far = kCorridorLength - kEnd;
  for (double x = kEnd; x <= far; x += 3) space.route.push_back({x, -kAside, kEye});
  space.route.push_back({far + kAside, 0, kEye});
  for (double x = far; x >= kEnd; x -= 3) space.route.push_back({x, kAside, kEye});
  space.route.push_back({kEnd - kAside, 0, kEye});
  return space;
}

}  // namespace framewise
