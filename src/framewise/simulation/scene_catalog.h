// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// A scene that can be asked for by name.
struct SceneKind {
  std::string name;
  std::function<Scene(const SceneOptions&)> build;
  PathSpace space;  // whatever the seed
  std::string default_path;
  bool is_lit = true;  // false: dark but for a headlamp
};

const std::vector<SceneKind>& scene_kinds();

// Throws std::invalid_argument for a name that is none.
const SceneKind& scene_kind(const std::string& name);

}  // namespace framewise
