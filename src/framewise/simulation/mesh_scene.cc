// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/mesh_scene.h"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "framewise/simulation/image_texture.h"
#include "framewise/simulation/random.h"

namespace framewise {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

Color color_of(const Vector3f& color) { return {color.x(), color.y(), color.z()}; }

// Cosine-weighted light of an overcast sky and of what the ground throws back, for a surface of this normal.
Color sky_light(const Vector3f& normal) {
  return Color{0.62f, 0.63f, 0.65f} * (1 + 0.35f * normal.z() + 0.1f * normal.x());
}

Vector3f cross_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3f &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]],
                 &c = mesh.positions[triangle[2]];
  return (b - a).cross(c - a);
}

// How long the width of each material's image is on the surface, on the mean (m).
std::vector<float> image_widths(const Mesh& mesh) {
  std::vector<double> area(mesh.materials.size(), 0), area_uv(mesh.materials.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size() && !mesh.uv.empty(); ++i) {
    const auto& corner = mesh.triangles[i];
    const Vector2f s = mesh.uv[corner[1]] - mesh.uv[corner[0]], t = mesh.uv[corner[2]] - mesh.uv[corner[0]];
    area[mesh.material_of_triangle[i]] += cross_of(mesh, corner).norm();
    area_uv[mesh.material_of_triangle[i]] += std::abs(s.x() * t.y() - s.y() * t.x());
  }
  std::vector<float> widths;
  for (std::size_t k = 0; k < area.size(); ++k)
    widths.push_back(area_uv[k] > 0 ? static_cast<float>(std::sqrt(area[k] / area_uv[k])) : 1);
  return widths;
}

Material material_of(const MeshMaterial& look, float width, Random& random) {
  Material material;
  material.seed = random.seed();
  material.width = material.height = width;
  if (look.emission.maxCoeff() > 0) {
    material.texture = Texture::kPlain;
    material.a = color_of(look.emission);
    material.emission = 1;
  } else if (!look.image.empty()) {
    material.texture = Texture::kImage;
    material.a = color_of(look.color);
    material.image = std::make_shared<const ImageTexture>(look.image);
  } else {
    material.texture = Texture::kPatchwork;
    material.a = material.b = color_of(look.color);
  }
  return material;
}

// Metres along the two axes that the face looks along least.
Vector2f uv_by_place(const Vector3f& position, const Vector3f& face_normal) {
  int away = 0;
  face_normal.cwiseAbs().maxCoeff(&away);
  return {position[(away + 1) % 3], position[(away + 2) % 3]};
}

void add_triangle(const Mesh& mesh, std::size_t i, Scene& scene) {
  const auto& corners = mesh.triangles[i];
  const Vector3f cross = cross_of(mesh, corners);
  if (!(cross.norm() > 0)) return;  // no area
  const Material& material = scene.materials[mesh.material_of_triangle[i]];
  std::array<std::uint32_t, 3> triangle;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t corner = corners[k];
    triangle[k] = static_cast<std::uint32_t>(scene.vertices.size());
    const Vector2f uv = material.texture == Texture::kImage && !mesh.uv.empty()
                            ? Vector2f(material.width * mesh.uv[corner])
                            : uv_by_place(mesh.positions[corner], cross);
    scene.vertices.push_back(
        {mesh.positions[corner], mesh.normals[corner], uv, sky_light(mesh.normals[corner])});
    if (!mesh.colors.empty()) scene.tints.push_back(color_of(mesh.colors[corner]));
  }
  scene.triangles.push_back(triangle);
  scene.material_of_triangle.push_back(mesh.material_of_triangle[i]);
}

}  // namespace

Scene mesh_scene(const Mesh& mesh, const SceneOptions& options) {
  Scene scene;
  Random random(options.seed ^ 0x4d657368u);
  const std::vector<float> widths = image_widths(mesh);
  for (std::size_t k = 0; k < mesh.materials.size(); ++k)
    scene.materials.push_back(material_of(mesh.materials[k], widths[k], random));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) add_triangle(mesh, i, scene);
  if (scene.triangles.empty())
    throw std::invalid_argument("mesh: found no face with an area, expected at least one");
  return scene;
}

Eigen::AlignedBox3d bounds_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) box.extend(mesh.positions[corner].cast<double>());
  return box;
}

PathSpace mesh_space(const Mesh& mesh) {
  const Eigen::AlignedBox3d box = bounds_of(mesh);
  const Vector3d middle = box.center();
  const double radius = std::max(1e-3, 0.5 * box.diagonal().norm());
  const Vector3d half(3.2 * radius, 3.2 * radius, 0.3 * radius);
  const Eigen::AlignedBox3d around(middle - half, middle + half);
  return {around, 0, round_way(around)};
}

}  // namespace framewise
