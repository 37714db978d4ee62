// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// A single textured plane, 28 m x 28 m, under an even sky: what many two-view methods cannot do.
Scene plane_scene(const SceneOptions& options);

// One to two metres above it, looking down at it.
PathSpace plane_space();

}  // namespace framewise
