// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/room_scene.h"

#include <cmath>

#include "framewise/simulation/furniture.h"
#include "framewise/simulation/light_baking.h"
#include "framewise/simulation/things.h"

namespace framewise {
namespace {

using Eigen::Vector3f;

constexpr float kLength = 6.2f, kWidth = 5.2f, kHeight = 2.65f;
// Turns (rad) of a piece at a wall, so that it faces into the room.
constexpr float kAtNorth = 0, kAtWest = 0.5f * static_cast<float>(M_PI), kAtSouth = static_cast<float>(M_PI),
                kAtEast = -0.5f * static_cast<float>(M_PI);

void shell(MeshBuilder& builder, Random& random) {
  builder.place({0, 0, 0});
  const Vector3f x(kLength, 0, 0), y(0, kWidth, 0), z(0, 0, kHeight);
  builder.set_cell_factor(0.8f);
  builder.quad({0, 0, 0}, x, y, {Texture::kPlanks, srgb(0x8a5a34), srgb(0xc4935c), random.seed()});
  builder.set_cell_factor(2.5f);
  builder.quad(z + y, x, -y, {Texture::kPlaster, srgb(0xe8e2d4), srgb(0xd2cab8), random.seed()});
  builder.set_cell_factor(1.5f);
  builder.quad(x, -x, z, {Texture::kWallpaper, srgb(0xd8d2b8), srgb(0x7f9a78), random.seed()});
  builder.quad(y, x, z, {Texture::kPlaster, srgb(0xd9b98c), srgb(0xc79a66), random.seed()});
  builder.quad({0, 0, 0}, y, z, {Texture::kBrick, srgb(0x9a4a34), srgb(0xb9704c), random.seed()});
  builder.quad(x + y, -y, z, {Texture::kPlaster, srgb(0xa9bcc4), srgb(0x8ba3ae), random.seed()});
  const Material beam = wood_of(random, srgb(0x4a3020), srgb(0x7a5636));
  for (const float at : {0.7f, 1.9f, 3.1f, 4.3f, 5.5f})
    builder.box({at - 0.07f, 0, kHeight - 0.12f}, {0.14f, kWidth, 0.12f}, beam);
  const Material skirting{Texture::kPaint, srgb(0xe4ded0), {}, random.seed()};
  builder.box({0, 0, 0}, {kLength, 0.015f, 0.09f}, skirting);
  builder.box({0, kWidth - 0.015f, 0}, {kLength, 0.015f, 0.09f}, skirting);
  builder.box({kLength - 0.015f, 0, 0}, {0.015f, kWidth, 0.09f}, skirting);
  builder.set_cell_factor(1);
}

void middle_of_room(MeshBuilder& builder, Random& random) {
  const Vector3f middle(0.5f * kLength, 0.5f * kWidth, 0);
  builder.place(middle);
  const Material woven{Texture::kCarpet, srgb(0x8c2f2b), srgb(0xe3cfa0), random.seed(), 2.9f, 2.1f};
  const Material hem{Texture::kFabric, srgb(0xcdbb94), srgb(0xe3d7b8), random.seed()};
  builder.box({-1.45f, -1.05f, 0.001f}, {2.9f, 2.1f, 0.012f}, {hem, hem, hem, hem, woven, hem});
  table(builder, random, 1.6f, 0.9f);
  const float top = 0.74f;
  chess_board(builder, random, {0.38f, 0.05f, top});
  fruit_bowl(builder, random, {-0.12f, 0.1f, top});
  book_pile(builder, random, {-0.55f, -0.2f, top}, 3);
  mug(builder, random, {0.05f, -0.27f, top});
  mug(builder, random, {-0.62f, 0.22f, top});
  const Material letter{Texture::kPrint, srgb(0xf4f1e8), srgb(0x24242c), random.seed(), 0.21f, 0.297f};
  builder.quad({-0.33f, -0.4f, top + 0.001f}, {0.21f, 0.02f, 0}, {-0.028f, 0.294f, 0}, letter);
  const Color seats[] = {srgb(0xb8423a), srgb(0xe0a83a), srgb(0x2f6b7a), srgb(0x4f7a46)};
  const float places[][3] = {
      {-0.4f, 0.68f, 0.1f}, {0.42f, 0.64f, -0.15f}, {-0.36f, -0.66f, 3.3f}, {0.44f, -0.7f, 2.95f}};
  for (int i = 0; i < 4; ++i) {
    builder.place(middle + Vector3f(places[i][0], places[i][1], 0.013f), places[i][2]);
    chair(builder, random, {Texture::kStriped, seats[i], seats[(i + 1) % 4], 0});
  }
  builder.place(middle + Vector3f(0, 0, kHeight));
  pendant_lamp(builder, random, 0.44f);
}

Material painting(Random& random) {
  constexpr Texture kKinds[] = {Texture::kAbstract, Texture::kLandscape, Texture::kMosaic, Texture::kPrint};
  constexpr std::uint32_t kGrounds[][2] = {
      {0xe8dcc0, 0xd07f4a}, {0xf0d8a8, 0x6fa8c8}, {0xd8c8a0, 0x2f4858}, {0xf0ece0, 0x2a2a34}};
  const int kind = random.below(4);
  return {kKinds[kind], srgb(kGrounds[kind][0]), srgb(kGrounds[kind][1]), random.seed()};
}

void hang(MeshBuilder& builder, Random& random, const Vector3f& at, float turn, float width, float height) {
  builder.place(at, turn);
  picture(builder, random, width, height, painting(random));
}

void south_wall(MeshBuilder& builder, Random& random) {
  builder.place({1.85f, 0, 0}, kAtSouth);
  bookshelf(builder, random, 2.5f, 2.1f, 6);
  builder.place({4.35f, 0, 0}, kAtSouth);
  desk(builder, random, 1.5f);
  hang(builder, random, {4.0f, 0, 1.75f}, kAtSouth, 0.55f, 0.75f);
  hang(builder, random, {4.85f, 0, 1.72f}, kAtSouth, 0.7f, 0.5f);
  builder.place({5.72f, 0.48f, 0});
  plant(builder, random, {0, 0, 0}, 1.05f);
}

void north_wall(MeshBuilder& builder, Random& random) {
  builder.place({2.6f, kWidth, 0}, kAtNorth);
  sofa(builder, random, 2.2f);
  hang(builder, random, {1.75f, kWidth, 1.6f}, kAtNorth, 0.62f, 0.82f);
  hang(builder, random, {2.75f, kWidth, 1.65f}, kAtNorth, 0.95f, 0.65f);
  hang(builder, random, {3.7f, kWidth, 1.58f}, kAtNorth, 0.55f, 0.75f);
  builder.place({5.05f, kWidth, 0}, kAtNorth);
  bookshelf(builder, random, 1.1f, 1.15f, 3);
  builder.place({4.05f, 4.85f, 0});
  floor_lamp(builder, random);
  hang(builder, random, {5.05f, kWidth, 1.7f}, kAtNorth, 0.8f, 0.6f);
  builder.place({0.5f, 4.75f, 0});
  plant(builder, random, {0, 0, 0}, 1.15f);
}

void west_wall(MeshBuilder& builder, Random& random) {
  builder.place({0, 2.5f, 0}, kAtWest);
  sideboard(builder, random, 2.3f);
  for (const float y : {1.75f, 3.1f}) {
    builder.place({0, y, y < 2 ? 1.65f : 1.5f}, kAtWest);
    wall_board(builder, random, 1.0f);
  }
  hang(builder, random, {0, 4.2f, 1.55f}, kAtWest, 0.6f, 0.8f);
  hang(builder, random, {0, 0.75f, 1.6f}, kAtWest, 0.5f, 0.68f);
}

void east_wall(MeshBuilder& builder, Random& random) {
  builder.place({kLength, 2.55f, 0.95f}, kAtEast);
  window_with_curtains(builder, random, 1.9f, 1.3f);
  builder.place({kLength, 2.55f, 0}, kAtEast);
  for (int rib = 0; rib < 16; ++rib) {  // of the radiator
    const Material enamel{Texture::kPaint, srgb(0xe6e2d8), {}, random.seed()};
    builder.box({-0.64f + 0.08f * static_cast<float>(rib), -0.1f, 0.14f}, {0.06f, 0.07f, 0.5f}, enamel);
  }
  hang(builder, random, {kLength, 4.55f, 1.65f}, kAtEast, 0.55f, 0.75f);
  hang(builder, random, {kLength, 0.6f, 1.75f}, kAtEast, 0.5f, 0.6f);
}

std::vector<AreaLight> lights() {
  const Vector3f middle(0.5f * kLength, 0.5f * kWidth, 0);
  const float lamp = kHeight - 0.445f;
  return {
      // The window, from just inside the frame.
      {{kLength - 0.06f, 3.5f, 0.95f}, {0, -1.9f, 0}, {0, 0, 1.3f}, Color{8.5f, 9.2f, 10.2f}},
      // The pendant lamp shines down.
      {middle + Vector3f(-0.15f, 0.15f, lamp), {0.3f, 0, 0}, {0, -0.3f, 0}, Color{62, 49, 34}},
      // The floor lamp shines up and into the room.
      {{3.95f, 4.75f, 1.66f}, {0.2f, 0, 0}, {0, 0.2f, 0}, Color{60, 45, 28}},
      {{3.95f, 4.64f, 1.36f}, {0.2f, 0, 0}, {0, 0, 0.25f}, Color{18, 13.5f, 8.4f}},
  };
}

}  // namespace

PathSpace room_space() {
  const Eigen::AlignedBox3d box{Eigen::Vector3d(1.1, 1.1, 1.28),
                                Eigen::Vector3d(kLength - 1.1, kWidth - 1.1, 1.72)};
  return {box, -13 * M_PI / 180, round_way(box)};
}

Scene room_scene(const SceneOptions& options) {
  Scene scene;
  MeshBuilder builder(scene, options.light_cell);
  Random random(options.seed);
  shell(builder, random);
  middle_of_room(builder, random);
  south_wall(builder, random);
  north_wall(builder, random);
  west_wall(builder, random);
  east_wall(builder, random);
  scene.lights = lights();
  if (options.lit) bake_light(scene);
  return scene;
}

}  // namespace framewise
