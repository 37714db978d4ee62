// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

// How a part of a mesh looks. Colours are linear red, green, blue.
struct MeshMaterial {
  Eigen::Vector3f color = {0.8f, 0.8f, 0.8f};  // diffuse reflectance, times the image's where there is one
  Eigen::Vector3f emission = {0, 0, 0};        // radiance of what shines by itself, 1 for white
  cv::Mat image;                               // CV_8UC3 blue green red (sRGB), or empty
};

// A model made of triangles: metres, world axes, z up.
struct Mesh {
  std::vector<Eigen::Vector3f> positions, normals;  // of each vertex; normals are unit, on the side seen
  std::vector<Eigen::Vector2f> uv;      // into the material's image, (0, 0) its lower left corner; or empty
  std::vector<Eigen::Vector3f> colors;  // of each vertex, times the material's; or empty
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> material_of_triangle;
  std::vector<MeshMaterial> materials;
};

}  // namespace framewise
