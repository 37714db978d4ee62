// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// An office corridor of 60 m x 2.4 m x 2.6 m whose fifteen bays are all alike: doors, shelves, rails, lamps.
Scene corridor_scene(const SceneOptions& options);

// Along its middle; the route goes down one side and comes back on the other.
PathSpace corridor_space();

}  // namespace framewise
