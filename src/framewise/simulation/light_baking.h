// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/simulation/scene.h"

namespace framewise {

// Fills the light at every vertex: shadowed light of the area lights and one diffuse bounce, sampled with
// fixed directions so that neighbours agree. The scene does not move and is Lambertian, so that frames need
// no shadow rays. The answer does not depend on the number of threads.
void bake_light(Scene& scene);

}  // namespace framewise
