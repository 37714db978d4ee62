// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/yaml_fields.h"

#include <fstream>
#include <iterator>

namespace framewise {
namespace {

std::string yaml_text(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw InputError(path, 0, "", "no file", "a camera file (YAML)");
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  // The line stays, empty, so that messages name the right ones.
  if (text.starts_with("%YAML:")) text.erase(0, text.find('\n'));
  return text;
}

}  // namespace

YamlFields::YamlFields(const std::filesystem::path& path) : path_(path) {
  try {
    root_ = YAML::Load(yaml_text(path));
  } catch (const YAML::Exception& error) {
    throw InputError(path, error.mark.line + 1, "", error.msg, "YAML");
  }
  if (!root_.IsMap())
    throw InputError(path, 0, "", "no map of fields", "a camera file (model, width, height, fx, …)");
}

YamlFields::YamlFields(const std::filesystem::path& path, const YAML::Node& map, const std::string& name)
    : path_(path), root_(map), prefix_(name + ".") {
  if (!root_.IsMap()) throw InputError(path, 0, name, "'" + YAML::Dump(root_) + "'", "a map of fields");
}

YamlFields YamlFields::map(const std::string& name) const {
  if (!has(name)) throw InputError(path_, 0, full_name(name), "nothing", "a map of fields");
  return {path_, root_[name], full_name(name)};
}

}  // namespace framewise
