// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace framewise::apps {

// Writes NAME.svg and NAME.png of each figure (name, SVG), the PNG at twice the figure's size. Throws
// InputError where the folder cannot be written and std::runtime_error where a figure cannot be drawn.
void write_figures(const std::filesystem::path& folder,
                   const std::vector<std::pair<std::string, std::string>>& figures);

}  // namespace framewise::apps
