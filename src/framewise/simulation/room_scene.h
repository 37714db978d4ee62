// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "framewise/simulation/scene.h"

namespace framewise {

struct RoomOptions {
  std::uint64_t seed = 0;    // textures, colours, and what stands on the shelves
  float light_cell = 0.05f;  // distance between the points where light is kept (m); coarser builds faster
  bool lit = true;           // false: the shape alone, for those who ask for no colour
};

// A furnished living room of 6.2 m x 5.2 m x 2.65 m, lit: table and chairs on a carpet under a lamp,
// bookshelf, desk, sofa, sideboard, plants, pictures, and a window with curtains.
Scene room_scene(const RoomOptions& options);

// Where a camera in the room is at least 0.4 m from everything.
Eigen::AlignedBox3d room_free_space();

}  // namespace framewise
