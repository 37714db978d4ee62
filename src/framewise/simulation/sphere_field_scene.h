// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// Some two hundred textured balls in the air of a hall of 13 m x 13 m x 8 m: depth everywhere, nothing flat.
Scene sphere_field_scene(const SceneOptions& options);

// In the middle of the hall, 0.5 m from the nearest ball or more.
PathSpace sphere_field_space();

}  // namespace framewise
