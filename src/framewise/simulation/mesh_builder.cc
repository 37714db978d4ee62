// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/mesh_builder.h"

#include <algorithm>
#include <cmath>

namespace framewise {

using Eigen::Vector2f;
using Eigen::Vector3f;

void MeshBuilder::place(const Vector3f& origin, float turn) {
  origin_ = origin;
  angle_ = turn;
  turn_ = Eigen::AngleAxisf(turn, Vector3f::UnitZ()).toRotationMatrix();
}

int MeshBuilder::cells_along(float length) const {
  return std::max(1, static_cast<int>(std::ceil(length / (cell_ * cell_factor_) - 1e-3f)));
}

std::uint32_t MeshBuilder::add_material(const Material& material) {
  scene_.materials.push_back(material);
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

void MeshBuilder::grid(std::vector<Vertex> corners, int nu, int nv, const Material& material) {
  const auto position = [&](int i, int j) {
    return corners[std::clamp(j, 0, nv - 1) * nu + std::clamp(i, 0, nu - 1)].position;
  };
  const std::uint32_t first = static_cast<std::uint32_t>(scene_.vertices.size()), id = add_material(material);
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      Vertex vertex = corners[j * nu + i];
      vertex.position = to_world(vertex.position);
      // Where a row shrinks to a point its neighbours still tell the direction.
      Vector3f along = position(i + 1, j) - position(i - 1, j),
               across = position(i, j + 1) - position(i, j - 1);
      if (along.norm() < 1e-6f)
        along = position(i + 1, j + (j == 0)) - position(i - 1, j + (j == 0)) + position(i + 1, j - (j > 0)) -
                position(i - 1, j - (j > 0));
      vertex.normal = turn_ * along.cross(across).normalized();
      scene_.vertices.push_back(vertex);
    }
  }
  const auto add_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3f &A = scene_.vertices[a].position, &B = scene_.vertices[b].position,
                   &C = scene_.vertices[c].position;
    if ((B - A).cross(C - A).norm() < 1e-10f) return;  // at a pole of a lathe
    scene_.triangles.push_back({a, b, c});
    scene_.material_of_triangle.push_back(id);
  };
  for (int j = 0; j + 1 < nv; ++j) {
    for (int i = 0; i + 1 < nu; ++i) {
      const std::uint32_t a = first + j * nu + i, b = a + 1, c = a + nu, d = c + 1;
      add_triangle(a, b, d);
      add_triangle(a, d, c);
    }
  }
}

void MeshBuilder::quad(const Vector3f& corner, const Vector3f& edge_u, const Vector3f& edge_v,
                       const Material& material) {
  const float width = edge_u.norm(), height = edge_v.norm();
  const int nu = cells_along(width) + 1, nv = cells_along(height) + 1;
  const FlatGrid flat{static_cast<std::uint32_t>(scene_.vertices.size()),
                      static_cast<std::uint32_t>(scene_.triangles.size()), static_cast<std::uint32_t>(nu),
                      static_cast<std::uint32_t>(nv)};
  sheet(nu, nv, false, material, [&](float s, float t) {
    return Vertex{corner + s * edge_u + t * edge_v, {}, {s * width, t * height}, {}};
  });
  if (scene_.triangles.size() - flat.first_triangle == std::size_t{2} * (flat.nu - 1) * (flat.nv - 1))
    scene_.flat_grids.push_back(flat);
}

void MeshBuilder::box(const Vector3f& corner, const Vector3f& size, const BoxMaterials& materials) {
  const Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  const auto side = [&](const Vector3f& from, const Vector3f& u, const Vector3f& v, Material material) {
    material.width = u.norm();
    material.height = v.norm();
    quad(corner + from, u, v, material);
  };
  side(Vector3f::Zero(), x, z, materials.front);
  side(x + y, -x, z, materials.back);
  side(y, -y, z, materials.left);
  side(x, y, z, materials.right);
  side(z, x, y, materials.top);
  side(y, x, -y, materials.bottom);
}

void MeshBuilder::box(const Vector3f& corner, const Vector3f& size, const Material& material) {
  BoxMaterials each{material, material, material, material, material, material};
  std::uint32_t k = 0;
  for (Material* side : {&each.front, &each.back, &each.left, &each.right, &each.top, &each.bottom})
    side->seed += 1013 * k++;
  box(corner, size, each);
}

void MeshBuilder::lathe(const Vector3f& centre, std::span<const Vector2f> profile, const Material& material) {
  float radius = 0;
  for (const Vector2f& p : profile) radius = std::max(radius, p.x());
  const float circumference = 2 * static_cast<float>(M_PI) * radius;
  const int around = std::max(16, cells_along(circumference));
  std::vector<float> arc{0};
  for (std::size_t j = 1; j < profile.size(); ++j)
    arc.push_back(arc.back() + (profile[j] - profile[j - 1]).norm());
  const float last = static_cast<float>(profile.size() - 1);
  sheet(around + 1, static_cast<int>(profile.size()), false, material, [&](float s, float t) {
    const int j = static_cast<int>(std::lround(t * last));
    const float angle = 2 * static_cast<float>(M_PI) * s;
    const Vector3f direction(std::cos(angle), std::sin(angle), 0);
    return Vertex{centre + profile[j].x() * direction + Vector3f(0, 0, profile[j].y()),
                  {},
                  {s * circumference, arc[j]},
                  {}};
  });
}

void MeshBuilder::cylinder(const Vector3f& centre, float radius, float height, const Material& material) {
  // Doubled corners keep the rims sharp.
  const float e = 1e-4f;
  std::vector<Vector2f> profile{{0, 0}, {radius - e, 0}, {radius, e}};
  const int n = cells_along(height);
  for (int j = 1; j < n; ++j)
    profile.push_back({radius, height * static_cast<float>(j) / static_cast<float>(n)});
  for (const Vector2f& p : {Vector2f(radius, height - e), Vector2f(radius - e, height), Vector2f(0, height)})
    profile.push_back(p);
  lathe(centre, profile, material);
}

void MeshBuilder::sphere(const Vector3f& centre, float radius, const Material& material) {
  std::vector<Vector2f> profile;
  const int n = std::max(12, cells_along(static_cast<float>(M_PI) * radius));
  for (int j = 0; j <= n; ++j) {
    const float angle = static_cast<float>(M_PI) * static_cast<float>(j) / static_cast<float>(n);
    profile.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  profile.front().x() = profile.back().x() = 0;
  lathe(centre, profile, material);
}

void MeshBuilder::cushion(const Vector3f& corner, const Vector3f& size, const Material& material) {
  const auto rounded = [](float c) { return std::copysign(std::pow(std::abs(c), 0.4f), c); };
  const int around = std::max(32, cells_along(2 * (size.x() + size.y()))),
            up = std::max(16, cells_along(2 * size.z()));
  // (u, v) lie in the two longer directions.
  int thin;
  size.minCoeff(&thin);
  const int across = thin == 0 ? 1 : 0, upward = thin == 2 ? 1 : 2;
  sheet(around + 1, up + 1, false, material, [&](float s, float t) {
    const float a = 2 * static_cast<float>(M_PI) * s, b = static_cast<float>(M_PI) * (t - 0.5f);
    const float ring = rounded(std::max(0.0f, std::cos(b)));
    const Vector3f x(ring * rounded(std::cos(a)), ring * rounded(std::sin(a)), rounded(std::sin(b)));
    const Vector3f along = 0.5f * size.cwiseProduct(x + Vector3f::Ones());
    return Vertex{corner + along, {}, {along[across], along[upward]}, {}};
  });
}

}  // namespace framewise
