// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "framewise/simulation/color.h"
#include "framewise/simulation/textures.h"

namespace framewise {

// A corner of a triangle. World axes, z up, metres.
struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;   // of the surface, unit, on the side that is seen
  Eigen::Vector2f uv;       // along the surface (m)
  Color light = {0, 0, 0};  // irradiance / pi: a white surface shows this radiance
};

// A rectangle that shines to the side of edge_u x edge_v.
struct AreaLight {
  Eigen::Vector3f corner, edge_u, edge_v;
  Color radiance;
};

// A parallelogram cut into cells of two triangles each, so that light can be kept at their corners: nu x nv
// vertices row by row, and for each cell in the same order the triangle below its diagonal and that above.
struct FlatGrid {
  std::uint32_t first_vertex, first_triangle;
  std::uint32_t nu, nv;
};

struct SceneOptions {
  std::uint64_t seed = 0;    // textures, colours, and what differs from one scene of a kind to another
  float light_cell = 0.05f;  // distance between the points where light is kept (m); coarser builds faster
  bool lit = true;           // false: the shape alone, for those who ask for no colour
};

// What there is to see, apart from who looks and from where.
struct Scene {
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> material_of_triangle;
  std::vector<Material> materials;
  std::vector<Color> tints;  // of each vertex, times the reflectance of its material; or empty
  std::vector<AreaLight> lights;
  std::vector<FlatGrid> flat_grids;  // of triangles that can be met faster together; in order, none twice
};

}  // namespace framewise
