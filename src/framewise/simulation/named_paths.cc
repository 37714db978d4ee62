// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <utility>

#include "framewise/simulation/path.h"

namespace framewise {
namespace {

using PathMaker = Path (*)(const PathSpace&, std::uint64_t);

const std::vector<std::pair<std::string, PathMaker>>& path_makers() {
  static const std::vector<std::pair<std::string, PathMaker>> makers{
      {"handheld", handheld_path},           {"orbit", orbit_path},     {"hover", hover_path},
      {"pure-rotation", pure_rotation_path}, {"forward", forward_path}, {"walk", walk_path},
      {"drone-race", drone_race_path}};
  return makers;
}

}  // namespace

const std::vector<std::string>& path_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, make] : path_makers()) all.push_back(name);
    return all;
  }();
  return names;
}

Path named_path(const std::string& name, const PathSpace& space, std::uint64_t seed) {
  std::string known;
  for (const auto& [candidate, make] : path_makers()) {
    if (candidate == name) return make(space, seed);
    known += (known.empty() ? "" : ", ") + candidate;
  }
  throw std::invalid_argument("path is '" + name + "', expected one of: " + known);
}

}  // namespace framewise
