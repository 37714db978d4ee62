// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// A furnished living room of 6.2 m x 5.2 m x 2.65 m, lit: table and chairs on a carpet under a lamp,
// bookshelf, desk, sofa, sideboard, plants, pictures, and a window with curtains.
Scene room_scene(const SceneOptions& options);

// Where a camera in the room is at least 0.4 m from everything.
PathSpace room_space();

}  // namespace framewise
