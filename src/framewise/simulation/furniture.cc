// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/furniture.h"

#include <algorithm>
#include <cmath>

#include "framewise/simulation/things.h"

namespace framewise {

using Eigen::Vector2f;
using Eigen::Vector3f;

Material wood_of(Random& random, Color dark, Color light) {
  return {Texture::kWood, dark, light, random.seed()};
}

namespace {

constexpr float kBoard = 0.025f;

Material oak(Random& random) { return wood_of(random, srgb(0x7d5634), srgb(0xc9a06a)); }
Material walnut(Random& random) { return wood_of(random, srgb(0x4a2f1f), srgb(0x8a6240)); }

void legs(MeshBuilder& builder, const Vector2f& half, float thickness, float height, const Material& wood) {
  for (const float x : {-half.x(), half.x() - thickness})
    for (const float y : {-half.y(), half.y() - thickness})
      builder.box({x, y, 0}, {thickness, thickness, height}, wood);
}

}  // namespace

void bookshelf(MeshBuilder& builder, Random& random, float width, float height, int boards) {
  const float depth = 0.32f, rise = (height - kBoard) / static_cast<float>(boards);
  builder.set_cell_factor(2);
  const Material wood = oak(random);
  builder.box({-0.5f * width, -depth, 0}, {kBoard, depth, height}, wood);
  builder.box({0.5f * width - kBoard, -depth, 0}, {kBoard, depth, height}, wood);
  builder.box({-0.5f * width, -0.02f, 0}, {width, 0.01f, height}, walnut(random));
  for (int i = 0; i <= boards; ++i)
    builder.box({-0.5f * width + kBoard, -depth + 0.005f, rise * static_cast<float>(i)},
                {width - 2 * kBoard, depth - 0.02f, kBoard}, wood);
  for (int i = 0; i < boards; ++i) {
    const float z = rise * static_cast<float>(i) + kBoard;
    row_of_things(builder, random, {-0.5f * width + kBoard, -0.03f, z}, width - 2 * kBoard,
                  rise - kBoard - 0.02f, depth - 0.06f);
  }
  builder.set_cell_factor(1);
}

void sideboard(MeshBuilder& builder, Random& random, float width) {
  const float depth = 0.4f, height = 0.72f;
  const Material wood = walnut(random), door = oak(random);
  builder.box({-0.5f * width, -depth, 0.1f}, {width, depth - 0.01f, height - 0.1f}, wood);
  const int doors = static_cast<int>(width / 0.45f);
  const float each = width / static_cast<float>(doors);
  for (int i = 0; i < doors; ++i) {
    const float x = -0.5f * width + each * static_cast<float>(i) + 0.012f;
    Material front = door;
    front.seed = random.seed();
    builder.box({x, -depth - 0.018f, 0.115f}, {each - 0.024f, 0.018f, height - 0.15f}, front);
    const Material knob{Texture::kPaint, srgb(0xd9c9a0), {}, random.seed()};
    builder.sphere({x + (i % 2 ? 0.05f : each - 0.074f), -depth - 0.03f, 0.45f}, 0.015f, knob);
  }
  for (const float x : {-0.46f * width, 0.46f * width - 0.05f})
    builder.box({x, -depth + 0.03f, 0}, {0.05f, depth - 0.06f, 0.1f}, wood);
  float x = -0.42f * width;
  while (x < 0.4f * width) {
    const Vector3f at(x, -0.5f * depth, height);
    switch (random.below(4)) {
      case 0:
        vase(builder, random, at, static_cast<float>(random.uniform(0.18, 0.34)));
        break;
      case 1:
        book_pile(builder, random, at, 3 + random.below(4));
        break;
      case 2:
        carton(builder, random, at, 0.24f);
        break;
      default:
        ball(builder, random, at, static_cast<float>(random.uniform(0.06, 0.11)));
        break;
    }
    x += static_cast<float>(random.uniform(0.3, 0.4));
  }
}

void desk(MeshBuilder& builder, Random& random, float width) {
  const float depth = 0.6f, height = 0.73f;
  const Material wood = oak(random);
  builder.box({-0.5f * width, -depth, height - 0.03f}, {width, depth - 0.01f, 0.03f}, wood);
  builder.place(builder.to_world({0, -0.5f * depth, 0}), builder.turn());
  legs(builder, {0.5f * width - 0.02f, 0.5f * depth - 0.02f}, 0.045f, height - 0.03f, walnut(random));
  const float drawer = 0.38f;
  builder.box({0.5f * width - drawer - 0.07f, -0.24f, 0.15f}, {drawer, 0.46f, height - 0.18f},
              walnut(random));
  // A screen that shows a page, a keyboard, paper, books.
  const Material dark{Texture::kPaint, srgb(0x22252a), {}, random.seed()};
  const Material page{Texture::kPrint, srgb(0xf2efe6), srgb(0x20304a), random.seed(), 0.56f, 0.34f};
  builder.box({-0.28f, 0.13f, height + 0.1f}, {0.56f, 0.025f, 0.34f}, {page, dark, dark, dark, dark, dark});
  builder.box({-0.03f, 0.135f, height}, {0.06f, 0.02f, 0.12f}, dark);
  builder.box({-0.12f, 0.06f, height}, {0.24f, 0.16f, 0.012f}, dark);
  const Material keys{Texture::kMosaic, srgb(0xd8d8d4), srgb(0x8f979e), random.seed(), 0.42f, 0.14f};
  builder.box({-0.21f, -0.2f, height}, {0.42f, 0.14f, 0.02f}, {dark, dark, dark, dark, keys, dark});
  book_pile(builder, random, {0.5f * width - 0.22f, 0.05f, height}, 5);
  carton(builder, random, {-0.5f * width + 0.2f, 0.08f, height}, 0.25f);
  mug(builder, random, {0.36f, -0.12f, height});
}

void sofa(MeshBuilder& builder, Random& random, float width) {
  const float depth = 0.9f, arm = 0.17f;
  const Material cloth{Texture::kFabric, srgb(0x2f5d6b), srgb(0x5f97a0), random.seed()};
  builder.box({-0.5f * width + 0.02f, -depth + 0.03f, 0.06f}, {width - 0.04f, depth - 0.05f, 0.24f}, cloth);
  builder.cushion({-0.5f * width, -depth, 0.05f}, {arm, depth - 0.02f, 0.56f}, cloth);
  builder.cushion({0.5f * width - arm, -depth, 0.05f}, {arm, depth - 0.02f, 0.56f}, cloth);
  builder.cushion({-0.5f * width + 0.08f, -0.27f, 0.2f}, {width - 0.16f, 0.25f, 0.63f}, cloth);
  const float seat = (width - 2 * arm) / 2;
  for (int i = 0; i < 2; ++i) {
    Material top = cloth;
    top.seed = random.seed();
    builder.cushion({-0.5f * width + arm + seat * static_cast<float>(i), -depth + 0.01f, 0.27f},
                    {seat, 0.68f, 0.17f}, top);
  }
  const Color colors[] = {srgb(0xd98e2b), srgb(0xb8423a), srgb(0xe3d9c0), srgb(0x3c7d5a)};
  for (int i = 0; i < 4; ++i) {
    const Material pillow{Texture::kStriped, colors[i], colors[(i + 2) % 4], random.seed()};
    const float x = -0.5f * width + arm + 0.05f + (width - 2 * arm - 0.5f) * static_cast<float>(i) / 3;
    builder.cushion({x, -0.47f - 0.03f * static_cast<float>(i % 2), 0.42f}, {0.4f, 0.15f, 0.36f}, pillow);
  }
}

void wall_board(MeshBuilder& builder, Random& random, float width) {
  builder.set_cell_factor(2);
  builder.box({-0.5f * width, -0.2f, -0.03f}, {width, 0.19f, 0.03f}, oak(random));
  row_of_things(builder, random, {-0.5f * width, -0.02f, 0}, width, 0.3f, 0.15f);
  builder.set_cell_factor(1);
}

void picture(MeshBuilder& builder, Random& random, float width, float height, const Material& painting) {
  const Material frame =
      random.below(2) ? walnut(random) : Material{Texture::kPaint, srgb(0x2a2a2c), {}, random.seed()};
  const float rim = 0.03f;
  Material image = painting;
  image.width = width;
  image.height = height;
  builder.quad({-0.5f * width, -0.015f, -0.5f * height}, {width, 0, 0}, {0, 0, height}, image);
  for (const float z : {-0.5f * height - rim, 0.5f * height})
    builder.box({-0.5f * width - rim, -0.03f, z}, {width + 2 * rim, 0.028f, rim}, frame);
  for (const float x : {-0.5f * width - rim, 0.5f * width})
    builder.box({x, -0.03f, -0.5f * height}, {rim, 0.028f, height}, frame);
}

void window_with_curtains(MeshBuilder& builder, Random& random, float width, float height) {
  Material view{Texture::kOutdoors, srgb(0x8fc0ea), srgb(0x4d7a3a), random.seed(), width, height};
  view.emission = 1.1f;
  builder.quad({-0.5f * width, -0.004f, 0}, {width, 0, 0}, {0, 0, height}, view);
  const Material frame{Texture::kPaint, srgb(0xe8e4da), {}, random.seed()};
  const float rim = 0.06f;
  for (const float x : {-0.5f * width - rim, -0.5f * rim, 0.5f * width})
    builder.box({x, -0.05f, 0}, {rim, 0.049f, height}, frame);
  for (const float z : {-rim, 0.62f * height, height})
    builder.box({-0.5f * width - rim, -0.055f, z}, {width + 2 * rim, 0.054f, rim}, frame);
  builder.box({-0.5f * width - 0.12f, -0.16f, -rim - 0.03f}, {width + 0.24f, 0.155f, 0.03f},
              {frame, frame, frame, frame,
               Material{Texture::kMarble, srgb(0xdedad2), srgb(0x6b6f76), random.seed()}, frame});
  builder.box({-0.5f * width - 0.5f, -0.14f, height + 0.18f}, {width + 1.0f, 0.03f, 0.03f}, walnut(random));
  const Material cloth{Texture::kStriped, srgb(0xc9b28a), srgb(0x8c3b34), random.seed()};
  for (const float side : {-1.0f, 1.0f}) {
    const float from = side * (0.5f * width + 0.46f), to = side * (0.5f * width - 0.08f);
    const float x0 = std::min(from, to), x1 = std::max(from, to), top = height + 0.19f, bottom = -0.78f;
    builder.sheet(64, 24, true, cloth, [&](float s, float t) {
      const float z = bottom + t * (top - bottom),
                  fold = 0.028f * std::sin(38 * s + 3 * side) * (1.2f - 0.5f * t);
      return Vertex{{x0 + s * (x1 - x0) + 0.02f * std::sin(23 * s + 2 * t), -0.12f + fold, z},
                    {},
                    {1.6f * s * (x1 - x0), z},
                    {}};
    });
  }
}

void table(MeshBuilder& builder, Random& random, float length, float width) {
  const float height = 0.74f, top = 0.035f;
  builder.set_cell_factor(0.4f);  // shadows of small things fall here
  builder.box({-0.5f * length, -0.5f * width, height - top}, {length, width, top}, oak(random));
  builder.set_cell_factor(1);
  builder.box({-0.5f * length + 0.07f, -0.5f * width + 0.07f, height - top - 0.08f},
              {length - 0.14f, width - 0.14f, 0.08f}, walnut(random));
  legs(builder, {0.5f * length - 0.05f, 0.5f * width - 0.05f}, 0.07f, height - top, oak(random));
}

void chair(MeshBuilder& builder, Random& random, const Material& seat) {
  const Material wood = walnut(random);
  legs(builder, {0.21f, 0.21f}, 0.035f, 0.44f, wood);
  builder.box({-0.22f, -0.22f, 0.42f}, {0.44f, 0.44f, 0.025f}, wood);
  Material pad = seat;
  pad.seed = random.seed();
  builder.cushion({-0.205f, -0.205f, 0.435f}, {0.41f, 0.39f, 0.05f}, pad);
  for (const float x : {-0.21f, 0.175f}) builder.box({x, 0.175f, 0.44f}, {0.035f, 0.035f, 0.42f}, wood);
  for (const float z : {0.55f, 0.66f, 0.77f}) builder.box({-0.175f, 0.182f, z}, {0.35f, 0.018f, 0.07f}, wood);
}

void floor_lamp(MeshBuilder& builder, Random& random) {
  const Material metal{Texture::kPaint, srgb(0x3a3632), {}, random.seed()};
  builder.cylinder({0, 0, 0}, 0.15f, 0.025f, metal);
  builder.cylinder({0, 0, 0.02f}, 0.014f, 1.4f, metal);
  Material shade{Texture::kGlow, srgb(0xffe2a8), srgb(0xd9a050), random.seed(), 1, 0.3f};
  shade.emission = 1.25f;
  const Vector2f profile[] = {
      {0.19f, 1.34f}, {0.178f, 1.41f}, {0.165f, 1.49f}, {0.152f, 1.57f}, {0.14f, 1.64f}};
  builder.lathe({0, 0, 0}, profile, shade);
  builder.cylinder({0, 0, 1.35f}, 0.17f, 0.004f, shade);
  builder.cylinder({0, 0, 1.63f}, 0.138f, 0.004f, shade);
}

void pendant_lamp(MeshBuilder& builder, Random& random, float length) {
  const Material metal{Texture::kPaint, srgb(0x2a2a2c), {}, random.seed()};
  builder.cylinder({0, 0, -length + 0.2f}, 0.006f, length - 0.2f, metal);
  const Material enamel{Texture::kCeramic, srgb(0xb84a32), srgb(0xf0dcb8), random.seed()};
  const Vector2f outside[] = {{0.24f, 0},     {0.232f, 0.035f}, {0.205f, 0.085f}, {0.15f, 0.135f},
                              {0.08f, 0.17f}, {0.03f, 0.2f},    {0, 0.205f}};
  builder.lathe({0, 0, -length}, outside, enamel);
  Material bulb{Texture::kGlow, srgb(0xfff0cf), srgb(0xffe2b0), random.seed(), 1, 0.1f};
  bulb.emission = 1.5f;
  const Vector2f inside[] = {{0, 0.012f}, {0.1f, 0.012f}, {0.236f, 0.002f}, {0.24f, 0}};
  builder.lathe({0, 0, -length}, inside, bulb);
}

}  // namespace framewise
