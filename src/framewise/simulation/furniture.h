// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/mesh_builder.h"
#include "framewise/simulation/random.h"

namespace framewise {

// Pieces are built where the builder is placed. A piece that stands at a wall has its origin on the floor (or
// the wall) in the middle of its back and faces -y; others have it in the middle of their footprint.

Material wood_of(Random& random, Color dark, Color light);

// At a wall.
void bookshelf(MeshBuilder& builder, Random& random, float width, float height, int boards);
void sideboard(MeshBuilder& builder, Random& random, float width);
void desk(MeshBuilder& builder, Random& random, float width);
void sofa(MeshBuilder& builder, Random& random, float width);
void wall_board(MeshBuilder& builder, Random& random, float width);
void picture(MeshBuilder& builder, Random& random, float width, float height, const Material& painting);
void window_with_curtains(MeshBuilder& builder, Random& random, float width, float height);

// Free standing.
void table(MeshBuilder& builder, Random& random, float length, float width);
void chair(MeshBuilder& builder, Random& random, const Material& seat);
void floor_lamp(MeshBuilder& builder, Random& random);
void pendant_lamp(MeshBuilder& builder, Random& random, float length);

}  // namespace framewise
