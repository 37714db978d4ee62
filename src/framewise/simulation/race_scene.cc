// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/race_scene.h"

#include <cmath>

#include "framewise/simulation/furniture.h"
#include "framewise/simulation/light_baking.h"
#include "framewise/simulation/things.h"

namespace framewise {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kHallLength = 44, kHallWidth = 26, kHallHeight = 9;

std::vector<Vector3d> gates() {
  return {{6, 6, 1.8},   {16, 4.5, 1.8}, {27, 5.5, 2.4},  {37, 6.5, 3.2}, {40, 13, 2.8},
          {34, 20, 1.9}, {25, 18, 2.2},  {15, 21.5, 3.0}, {6, 20, 2.4},   {4, 13, 1.8}};
}

void race_hall(MeshBuilder& builder, Random& random) {
  const Vector3f x(kHallLength, 0, 0), y(0, kHallWidth, 0), z(0, 0, kHallHeight);
  const auto wall = [&](std::uint32_t a, std::uint32_t b) {
    return Material{Texture::kConcrete, srgb(a), srgb(b), random.seed()};
  };
  builder.set_cell_factor(12);
  builder.quad({0, 0, 0}, x, y, {Texture::kPlanks, srgb(0x9a7448), srgb(0xb98c5c), random.seed()});
  builder.quad(z + y, x, -y, wall(0xa8a8a4, 0x989890));
  builder.quad(x, -x, z, wall(0xb8b4a8, 0x9c988c));
  builder.quad(y, x, z, wall(0xb0b4b8, 0x949aa0));
  builder.quad({0, 0, 0}, y, z, wall(0xb8aca0, 0xa09488));
  builder.quad(x + y, -y, z, wall(0xa8b4a8, 0x909c90));
  builder.set_cell_factor(6);
}

// A square frame to fly through along a heading.
void gate(MeshBuilder& builder, Random& random, const Vector3d& centre, double heading) {
  constexpr float kOpen = 1.25f, kBeam = 0.22f, kThick = 0.15f;  // half the opening; the beams
  constexpr std::uint32_t kColors[] = {0xe04020, 0x2060c0, 0xf0b020, 0x30a050, 0xd03080};
  builder.place(centre.cast<float>(), static_cast<float>(heading));
  const Material cloth{Texture::kStriped, srgb(kColors[random.below(5)]), srgb(0xf0f0f0), random.seed()};
  const float whole = 2 * (kOpen + kBeam);
  for (const float at : {-kOpen - kBeam, kOpen}) {
    builder.box({-0.5f * kThick, at, -kOpen}, {kThick, kBeam, 2 * kOpen}, cloth);
    builder.box({-0.5f * kThick, -0.5f * whole, at}, {kThick, whole, kBeam}, cloth);
  }
  const float below = static_cast<float>(centre.z()) - kOpen - kBeam;  // legs down to the floor
  if (below < 0.05f) return;
  const Material steel{Texture::kPaint, srgb(0x303438), {}, random.seed()};
  for (const float y : {-kOpen - 0.5f * kBeam, kOpen + 0.5f * kBeam})
    builder.box({-0.04f, y - 0.04f, -kOpen - kBeam - below}, {0.08f, 0.08f, below}, steel);
}

void banners(MeshBuilder& builder, Random& random) {
  constexpr Texture kKinds[] = {Texture::kAbstract, Texture::kPrint, Texture::kMosaic, Texture::kLandscape};
  const auto hang = [&](const Vector3f& at, float turn) {
    builder.place(at, turn);
    const Material print{kKinds[random.below(4)], srgb(0xf0e8d8), srgb(0x304868), random.seed(), 3.2f, 2.0f};
    builder.box({-1.6f, -0.03f, 0}, {3.2f, 0.03f, 2.0f}, print);
  };
  const float pi = static_cast<float>(M_PI);
  for (float x = 4; x < kHallLength; x += 6) {
    hang({x, kHallWidth, 2.2f}, 0);
    hang({x, 0, 2.2f}, pi);
  }
  for (float y = 4; y < kHallWidth; y += 6) {
    hang({0, y, 2.2f}, 0.5f * pi);
    hang({kHallLength, y, 2.2f}, -0.5f * pi);
  }
}

void things_on_the_floor(MeshBuilder& builder, Random& random) {
  builder.place({0, 0, 0});
  const Material steel{Texture::kRock, srgb(0x6a7078), srgb(0x8a9098), random.seed()};
  for (const float x : {11.0f, 33.0f})
    for (const float y : {9.5f, 16.0f}) builder.cylinder({x, y, 0}, 0.3f, kHallHeight, steel);
  constexpr float kCrates[][3] = {{10, 1.2f, 1.1f},  {21, 1.5f, 0.9f}, {31, 24.6f, 1.2f}, {42.4f, 22, 1.0f},
                                  {19, 24.5f, 0.8f}, {1.6f, 24, 1.3f}, {42.5f, 3, 1.2f},  {30, 12.5f, 0.7f}};
  for (const auto& at : kCrates) carton(builder, random, {at[0], at[1], 0}, at[2]);
}

std::vector<AreaLight> ceiling_lights() {
  std::vector<AreaLight> lights;
  for (const float x : {3.0f, 17.0f, 31.0f})
    for (const float y : {5.0f, 17.0f})
      lights.push_back({{x, y + 4, kHallHeight - 0.02f}, {10, 0, 0}, {0, -4, 0}, Color{4.2f, 4.2f, 4.0f}});
  return lights;
}

}  // namespace

Scene race_scene(const SceneOptions& options) {
  Scene scene;
  MeshBuilder builder(scene, options.light_cell);
  Random random(options.seed ^ 0x4761746573u);
  builder.place({0, 0, 0});
  race_hall(builder, random);
  const auto all = gates();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vector3d way = all[(i + 1) % all.size()] - all[(i + all.size() - 1) % all.size()];
    gate(builder, random, all[i], std::atan2(way.y(), way.x()));
  }
  banners(builder, random);
  things_on_the_floor(builder, random);
  scene.lights = ceiling_lights();
  if (options.lit) bake_light(scene);
  return scene;
}

PathSpace race_space() { return {{Vector3d(17, 9.5, 1.3), Vector3d(27, 13.5, 2.6)}, 0, gates()}; }

}  // namespace framewise
