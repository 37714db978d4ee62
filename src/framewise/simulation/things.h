// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/mesh_builder.h"
#include "framewise/simulation/random.h"

namespace framewise {

// Things that stand on furniture. Each stands at a point of the builder's frame.
void vase(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at, float height);
void fruit_bowl(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at);
void book_pile(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at, int count);
void mug(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at);
void ball(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at, float radius);
void carton(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at, float size);
void chess_board(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at);
void plant(MeshBuilder& builder, Random& random, const Eigen::Vector3f& at, float height);

// Books, and between them boxes, vases and balls, from a lower back left corner along +x, fronts towards -y.
void row_of_things(MeshBuilder& builder, Random& random, const Eigen::Vector3f& back_left, float width,
                   float height, float depth);

}  // namespace framewise
