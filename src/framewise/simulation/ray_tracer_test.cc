// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/ray_tracer.h"

#include <gtest/gtest.h>

#include "framewise/simulation/mesh_builder.h"
#include "framewise/simulation/random.h"

namespace framewise {
namespace {

// A slanted parallelogram of 7 x 4 cells with a ball before it.
Scene face_and_ball() {
  Scene scene;
  MeshBuilder builder(scene, 0.3f);
  builder.sphere({0.2f, 0.1f, 0.4f}, 0.3f, {});
  builder.quad({-1, -0.6f, -0.2f}, {2, 0.2f, 0.1f}, {0.3f, 1.1f, 0.05f}, {});
  for (std::size_t i = 0; i < scene.vertices.size(); ++i)
    scene.vertices[i].light = {0.01f * static_cast<float>(i), 1, 0};
  return scene;
}

Rays8 rays_down(Random& random) {
  Rays8 rays;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3f direction(static_cast<float>(random.uniform(-0.5, 0.5)),
                                    static_cast<float>(random.uniform(-0.5, 0.5)), -1);
    rays.set(i, {0, 0, 2}, direction, 0, 100);
  }
  return rays;
}

TEST(RayTracer, AFaceCutIntoCellsIsMetWhereItsTrianglesAre) {
  const Scene scene = face_and_ball();
  ASSERT_EQ(scene.flat_grids.size(), 1u);
  Scene one_by_one = scene;
  one_by_one.flat_grids.clear();
  const RayTracer tracer(scene), judge(one_by_one);
  Random random(4);
  int of_face = 0;
  for (int k = 0; k < 200; ++k) {
    const Rays8 rays = rays_down(random);
    Hits8 hits, expected;
    tracer.intersect(rays, true, hits);
    judge.intersect(rays, true, expected);
    for (int i = 0; i < 8; ++i) {
      ASSERT_EQ(hits.triangle[i] == kNoHit, expected.triangle[i] == kNoHit);
      if (hits.triangle[i] == kNoHit) continue;
      of_face += hits.triangle[i] >= scene.flat_grids[0].first_triangle;
      ASSERT_NEAR(hits.t[i], expected.t[i], 1e-5);
      // Of two triangles that meet at the place either may be named: light and (u, v) are one.
      const SurfacePoint at = tracer.surface_point(hits[i]), there = judge.surface_point(expected[i]);
      ASSERT_NEAR(at.u, there.u, 1e-5);
      ASSERT_NEAR(at.v, there.v, 1e-5);
      ASSERT_NEAR(at.light.r, there.light.r, 1e-4);
    }
  }
  EXPECT_GT(of_face, 300);
}

TEST(RayTracer, TheExactPlaceIsTheHitInDoublePrecision) {
  const Scene scene = face_and_ball();
  const RayTracer tracer(scene);
  Random random(5);
  for (int k = 0; k < 50; ++k) {
    const Rays8 rays = rays_down(random);
    Hits8 hits;
    tracer.intersect(rays, true, hits);
    for (int i = 0; i < 8; ++i) {
      if (hits.triangle[i] == kNoHit) continue;
      const Eigen::Vector3d direction(rays.direction_x[i], rays.direction_y[i], -1);
      EXPECT_NEAR(tracer.exact_t(hits.triangle[i], {0, 0, 2}, direction), hits.t[i], 1e-5);
    }
  }
}

}  // namespace
}  // namespace framewise
