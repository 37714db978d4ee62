// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/scene_catalog.h"

#include <stdexcept>

#include "framewise/simulation/corridor_scene.h"
#include "framewise/simulation/mine_scene.h"
#include "framewise/simulation/plane_scene.h"
#include "framewise/simulation/race_scene.h"
#include "framewise/simulation/room_scene.h"
#include "framewise/simulation/sphere_field_scene.h"

namespace framewise {

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds{
      {"room", room_scene, room_space(), "handheld"},
      {"corridor", corridor_scene, corridor_space(), "walk"},
      {"mine", mine_scene, mine_space(), "walk", false},
      {"race", race_scene, race_space(), "drone-race"},
      {"plane", plane_scene, plane_space(), "handheld"},
      {"sphere-field", sphere_field_scene, sphere_field_space(), "orbit"},
  };
  return kinds;
}

const SceneKind& scene_kind(const std::string& name) {
  std::string known;
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.name == name) return kind;
    known += (known.empty() ? "" : ", ") + kind.name;
  }
  throw std::invalid_argument("scene is '" + name + "', expected one of: " + known);
}

}  // namespace framewise
