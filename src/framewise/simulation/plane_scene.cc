// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/plane_scene.h"

#include "framewise/simulation/light_baking.h"
#include "framewise/simulation/mesh_builder.h"
#include "framewise/simulation/random.h"

namespace framewise {

Scene plane_scene(const SceneOptions& options) {
  Scene scene;
  MeshBuilder builder(scene, options.light_cell);
  Random random(options.seed);
  builder.set_cell_factor(20);
  builder.quad({-14, -14, 0}, {28, 0, 0}, {0, 28, 0},
               {Texture::kPatchwork, srgb(0xc9a878), srgb(0x7f9a8a), random.seed()});
  scene.lights = {{{-8, 8, 8}, {16, 0, 0}, {0, -16, 0}, Color{1.3f, 1.28f, 1.22f}}};
  if (options.lit) bake_light(scene);
  return scene;
}

PathSpace plane_space() {
  return {{Eigen::Vector3d(-1.5, -1.5, 1.2), Eigen::Vector3d(1.5, 1.5, 2.2)},
          -55 * M_PI / 180,
          round_way({Eigen::Vector3d(-5, -5, 1.4), Eigen::Vector3d(5, 5, 2.0)})};
}

}  // namespace framewise
