// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "config.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "framewise/io/input_error.h"

namespace framewise::apps {

void apply_config(CLI::App& command, const std::filesystem::path& path) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path.string());
  } catch (const YAML::BadFile&) {
    throw InputError(path, 0, "", "no file", "options in YAML");
  } catch (const YAML::Exception& error) {
    throw InputError(path, error.mark.line + 1, "", error.msg, "options in YAML");
  }
  if (!root.IsMap()) throw InputError(path, 0, "", "no map", "lines of 'option: value'");
  for (const auto& entry : root) {
    const auto name = entry.first.as<std::string>();
    CLI::Option* option = command.get_option_no_throw("--" + name);
    if (!option || !entry.second.IsScalar())
      throw InputError(path, entry.first.Mark().line + 1, "", "'" + name + "'",
                       "the name of an option and one value (framewise " + command.get_name() + " --help)");
    if (option->count() > 0) continue;
    try {
      option->add_result(entry.second.Scalar());
      option->run_callback();
    } catch (const CLI::Error& error) {
      throw InputError(path, 0, name, "'" + entry.second.Scalar() + "'", error.what());
    }
  }
}

}  // namespace framewise::apps
