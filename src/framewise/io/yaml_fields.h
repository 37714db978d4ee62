// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>

#include "framewise/io/input_error.h"

namespace framewise {

// Reads typed fields of a YAML map and says which one is wrong. Inside the room alone: no header of the
// library shows yaml-cpp.
class YamlFields {
 public:
  // A whole file. OpenCV's files begin with "%YAML:1.0", which is no YAML: that line is left out.
  explicit YamlFields(const std::filesystem::path& path);

  // A map inside another; `name` goes before the names of its fields in messages.
  YamlFields(const std::filesystem::path& path, const YAML::Node& map, const std::string& name);

  const std::filesystem::path& path() const { return path_; }
  bool has(const std::string& name) const { return root_.IsMap() && static_cast<bool>(root_[name]); }
  std::string full_name(const std::string& name) const { return prefix_ + name; }

  // The map called so. Throws where there is none, or something else.
  YamlFields map(const std::string& name) const;

  template <typename T>
  T get(const std::string& name, const std::string& expected) const {
    if (!has(name)) throw InputError(path_, 0, full_name(name), "nothing", expected);
    try {
      return root_[name].as<T>();
    } catch (const YAML::Exception&) {
      throw InputError(path_, 0, full_name(name), "'" + YAML::Dump(root_[name]) + "'", expected);
    }
  }

  template <typename T>
  T get_or(const std::string& name, const T& otherwise, const std::string& expected) const {
    return has(name) ? get<T>(name, expected) : otherwise;
  }

 private:
  std::filesystem::path path_;
  YAML::Node root_;
  std::string prefix_;
};

}  // namespace framewise
