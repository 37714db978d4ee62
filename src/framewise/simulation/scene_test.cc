// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framewise/simulation/ray_tracer.h"
#include "framewise/simulation/scene_catalog.h"

namespace framewise {
namespace {

class EveryScene : public testing::TestWithParam<std::string> {
 protected:
  const SceneKind& kind_ = scene_kind(GetParam());
  Scene shape(std::uint64_t seed) const {
    return kind_.build({.seed = seed, .light_cell = 10, .lit = false});
  }
};

// How far it is from a place to the nearest thing, by rays in 26 directions.
float clearance(const RayTracer& tracer, const Eigen::Vector3f& place) {
  std::vector<Eigen::Vector3f> directions;
  for (const float x : {-1.0f, 0.0f, 1.0f})
    for (const float y : {-1.0f, 0.0f, 1.0f})
      for (const float z : {-1.0f, 0.0f, 1.0f})
        if (x != 0 || y != 0 || z != 0) directions.push_back(Eigen::Vector3f(x, y, z).normalized());
  float nearest = 1e4f;
  for (std::size_t first = 0; first < directions.size(); first += 8) {
    Rays8 rays;
    for (std::size_t i = 0; i < 8; ++i) {
      if (first + i < directions.size())
        rays.set(static_cast<int>(i), place, directions[first + i], 0, 1e4f);
      else
        rays.switch_off(static_cast<int>(i));
    }
    Hits8 hits;
    tracer.intersect(rays, false, hits);
    for (int i = 0; i < 8; ++i)
      if (hits.triangle[i] != kNoHit) nearest = std::min(nearest, hits.t[i]);
  }
  return nearest;
}

TEST_P(EveryScene, NoPathComesNearAnything) {
  for (const std::uint64_t seed : {0, 7}) {
    const Scene scene = shape(seed);
    const RayTracer tracer(scene);
    for (const std::string& name : path_names()) {
      const Path path = named_path(name, kind_.space, seed);
      float nearest = 1e4f;
      for (int i = 0; i < 1200; ++i)
        nearest = std::min(nearest, clearance(tracer, path(0.083 * i).world_from_cam.t.cast<float>()));
      EXPECT_GT(nearest, 0.3f) << name << ", seed " << seed;
    }
  }
}

TEST_P(EveryScene, IsWellFormedAndDependsOnItsSeed) {
  const Scene scene = shape(1), other = shape(2);
  ASSERT_FALSE(scene.triangles.empty());
  ASSERT_EQ(scene.triangles.size(), scene.material_of_triangle.size());
  for (const auto& triangle : scene.triangles)
    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, scene.vertices.size());
  for (const Vertex& vertex : scene.vertices) {
    ASSERT_TRUE(vertex.position.allFinite());
    ASSERT_NEAR(vertex.normal.norm(), 1, 1e-3);
  }
  EXPECT_NE(scene.materials.front().seed, other.materials.front().seed);
}

std::vector<std::string> scene_names_for_tests() {
  std::vector<std::string> names;
  for (const SceneKind& kind : scene_kinds()) names.push_back(kind.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(scene_names_for_tests()),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace framewise
