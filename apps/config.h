// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

namespace framewise::apps {

// Gives every option of the command that was not typed the value it has in a YAML file of "option: value"
// lines, the names being those of the command line without dashes. Throws InputError for unknown names and
// bad values.
void apply_config(CLI::App& command, const std::filesystem::path& path);

}  // namespace framewise::apps
