// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "framewise/simulation/scene.h"

namespace framewise {

// Adds shapes to a scene. Light is kept at corners of triangles, so large faces are cut into cells.
class MeshBuilder {
 public:
  // cell: side of the cells that faces are cut into (m).
  MeshBuilder(Scene& scene, float cell) : scene_(scene), cell_(cell) {}

  // What follows is cut into cells this much smaller (below 1) or larger than usual, for finer or coarser
  // shadows.
  void set_cell_factor(float factor) { cell_factor_ = factor; }

  // Shapes are placed by this: turned about z by an angle (rad), then moved.
  void place(const Eigen::Vector3f& origin, float turn = 0);
  float turn() const { return angle_; }
  Eigen::Vector3f to_world(const Eigen::Vector3f& x) const { return turn_ * x + origin_; }

  // A parallelogram seen from the side of edge_u x edge_v; (u, v) run along the edges from the corner.
  void quad(const Eigen::Vector3f& corner, const Eigen::Vector3f& edge_u, const Eigen::Vector3f& edge_v,
            const Material& material);

  // A box by its lowest corner and its size. Each side has (u, v) from its lower left, seen from outside.
  struct BoxMaterials {
    Material front, back, left, right, top, bottom;  // front is -y, left is -x
  };
  void box(const Eigen::Vector3f& corner, const Eigen::Vector3f& size, const BoxMaterials& materials);
  void box(const Eigen::Vector3f& corner, const Eigen::Vector3f& size, const Material& material);

  // A profile (radius, z), from below to above, turned about the vertical through the centre.
  void lathe(const Eigen::Vector3f& centre, std::span<const Eigen::Vector2f> profile,
             const Material& material);
  void cylinder(const Eigen::Vector3f& centre, float radius, float height, const Material& material);
  void sphere(const Eigen::Vector3f& centre, float radius, const Material& material);

  // A box with round edges, for what is upholstered: |x|^p + |y|^p + |z|^p = 1 with p = 5, stretched to the
  // size.
  void cushion(const Eigen::Vector3f& corner, const Eigen::Vector3f& size, const Material& material);

  // A grid of nu x nv corners given by a function of two numbers from 0 to 1; seen from both sides if asked.
  template <typename Function>
  void sheet(int nu, int nv, bool two_sided, const Material& material, Function point_at);

 private:
  int cells_along(float length) const;
  std::uint32_t add_material(const Material& material);
  // Cuts a grid of corners (row by row) into triangles; corner normals come from the grid itself.
  void grid(std::vector<Vertex> corners, int nu, int nv, const Material& material);

  Scene& scene_;
  float cell_, cell_factor_ = 1;
  float angle_ = 0;
  Eigen::Matrix3f turn_ = Eigen::Matrix3f::Identity();
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
};

template <typename Function>
void MeshBuilder::sheet(int nu, int nv, bool two_sided, const Material& material, Function point_at) {
  std::vector<Vertex> corners;
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i)
      corners.push_back(point_at(static_cast<float>(i) / static_cast<float>(nu - 1),
                                 static_cast<float>(j) / static_cast<float>(nv - 1)));
  grid(corners, nu, nv, material);
  if (!two_sided) return;
  std::vector<Vertex> mirrored;
  for (int j = 0; j < nv; ++j)
    for (int i = nu - 1; i >= 0; --i) mirrored.push_back(corners[j * nu + i]);
  grid(mirrored, nu, nv, material);
}

}  // namespace framewise
