// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/mine_scene.h"

#include <cmath>

#include "framewise/simulation/furniture.h"
#include "framewise/simulation/noise.h"

namespace framewise {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kPi = M_PI;
constexpr double kWayLength = 95;    // about, of the middle line (m)
constexpr double kRadius = 1.85;     // of the gallery, before the rock's roughness (m)
constexpr double kRoughness = 0.42;  // beyond which rock stands neither out nor back (m)
constexpr double kFloor = 1.45;      // below the middle line (m)
constexpr int kSets = 19;            // of timber

// The middle line, once round as the angle goes round.
Vector3d middle(double angle) {
  const double radius = 14 + 2.2 * std::sin(2 * angle + 0.5) + 1.4 * std::sin(3 * angle + 2.1);
  return {radius * std::cos(angle), radius * std::sin(angle),
          0.5 * std::sin(angle + 1) + 0.3 * std::sin(2 * angle)};
}

Vector3d ahead(double angle) { return (middle(angle + 1e-4) - middle(angle - 1e-4)).normalized(); }
Vector3d left(double angle) { return Vector3d::UnitZ().cross(ahead(angle)).normalized(); }

// How far the rock stands back: waves around and along the gallery from metres down to decimetres, the
// shorter the lower.
class Roughness {
 public:
  explicit Roughness(Random& random) {
    for (int k = 0; k < 64; ++k) {
      const double length = 6 * std::pow(0.04, k / 63.0);  // of the wave (m), 6 to 0.24
      const double direction = random.uniform(0, kPi);
      waves_.push_back({std::round(2 * kPi * kRadius / length * std::cos(direction)),
                        std::round(kWayLength / length * std::sin(direction)), 0.055 * std::pow(length, 0.8),
                        random.uniform(0, 2 * kPi)});
    }
  }

  double operator()(double around, double along) const {
    double sum = 0;
    for (const Wave& w : waves_) sum += w.height * std::cos(w.around * around + w.along * along + w.phase);
    return kRoughness * std::tanh(sum / kRoughness);
  }

 private:
  struct Wave {
    double around, along, height, phase;  // waves in one turn, at that
  };
  std::vector<Wave> waves_;
};

// `cell`: side of the triangles (m).
void rock(MeshBuilder& builder, Random& random, float cell) {
  const Roughness roughness(random);
  const Material stone{Texture::kRock, srgb(0x8a7a68), srgb(0x5a5450), random.seed()};
  const int along = std::max(64, static_cast<int>(kWayLength / cell)),
            around = std::max(24, static_cast<int>(2 * kPi * kRadius / cell));
  builder.sheet(along + 1, around + 1, false, stone, [&](float s, float t) {
    const double angle = 2 * kPi * static_cast<double>(s), turn = 2 * kPi * (static_cast<double>(t) - 0.25);
    const double radius = kRadius + roughness(turn, angle);
    const Vector3d point =
        middle(angle) + radius * (std::cos(turn) * left(angle) + std::sin(turn) * Vector3d::UnitZ());
    return Vertex{point.cast<float>(),
                  {},
                  {static_cast<float>(kWayLength) * s, static_cast<float>(2 * kPi * kRadius) * t},
                  {}};
  });
}

void ground(MeshBuilder& builder, Random& random, float cell) {
  const Material gravel{Texture::kGravel, srgb(0x6a6058), srgb(0x4a4642), random.seed()};
  const float width = 3.6f;
  const std::uint32_t seed = random.seed();
  const int along = std::max(64, static_cast<int>(kWayLength / cell)),
            across = std::max(4, static_cast<int>(width / cell));
  builder.sheet(along + 1, across + 1, false, gravel, [&](float s, float t) {
    const double angle = 2 * kPi * static_cast<double>(s);
    const float u = static_cast<float>(kWayLength) * s, v = width * (t - 0.5f);
    const Vector3d point = middle(angle) + static_cast<double>(v) * left(angle) - Vector3d(0, 0, kFloor);
    // Level where the way closes, so that it does.
    const float fade = std::min(1.0f, 20 * std::min(s, 1 - s));
    const float bump = 0.05f * fade * fractal_noise(u, v, 0.9f, 0.5f, 0.1f, seed);
    return Vertex{point.cast<float>() + Vector3f(0, 0, bump), {}, {u, v}, {}};
  });
}

// Two posts and a cap across the gallery.
void timber(MeshBuilder& builder, Random& random, double angle) {
  const Vector3d way = ahead(angle);
  builder.place((middle(angle) - Vector3d(0, 0, kFloor)).cast<float>(),
                static_cast<float>(std::atan2(way.y(), way.x())));
  for (const float y : {-1.25f, 1.07f})
    builder.box({-0.09f, y, -0.1f}, {0.18f, 0.18f, 2.42f}, wood_of(random, srgb(0x4a3622), srgb(0x7a5c3c)));
  builder.box({-0.1f, -1.6f, 2.3f}, {0.2f, 3.2f, 0.2f}, wood_of(random, srgb(0x4a3622), srgb(0x7a5c3c)));
}

}  // namespace

Scene mine_scene(const SceneOptions& options) {
  Scene scene;
  MeshBuilder builder(scene, 1);
  Random random(options.seed ^ 0x4d696e6500u);
  const float cell = std::max(0.07f, std::min(0.35f, 1.4f * options.light_cell));
  builder.place({0, 0, 0});
  rock(builder, random, cell);
  ground(builder, random, 2 * cell);
  for (int k = 0; k < kSets; ++k)
    timber(builder, random, 2 * kPi * (k + random.uniform(-0.15, 0.15)) / kSets);
  return scene;
}

PathSpace mine_space() {
  const Vector3d here = middle(0.17) + Vector3d(0, 0, 0.1);
  PathSpace space{{here - Vector3d(0.3, 0.8, 0.25), here + Vector3d(0.3, 0.8, 0.25)}, -5 * kPi / 180, {}};
  constexpr int kCorners = 40;
  for (int k = 0; k < kCorners; ++k)
    space.route.push_back(middle(2 * kPi * k / kCorners) + Vector3d(0, 0, 0.1));
  return space;
}

}  // namespace framewise
