// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// A gallery of a mine that comes back to its beginning after some 90 m: rough rock about 3.5 m wide, gravel,
// sets of timber. There is no light in it but what one brings.
Scene mine_scene(const SceneOptions& options);

// Along its middle.
PathSpace mine_space();

}  // namespace framewise
