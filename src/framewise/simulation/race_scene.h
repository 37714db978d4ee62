// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// A hall of 44 m x 26 m x 9 m with ten gates to fly through, pillars, crates and banners.
Scene race_scene(const SceneOptions& options);

// The middle of the hall; the route leads through the gates.
PathSpace race_space();

}  // namespace framewise
