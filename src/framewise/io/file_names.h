// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace framewise {

// Whether a comes before b where runs of digits count as numbers: "img2" before "img10", "img02" before
// "img2".
bool natural_less(std::string_view a, std::string_view b);

// The names (not paths) of a folder's files that end in one of `extensions` (small letters, with the dot;
// capitals are as good), in natural order. Empty where there is no such folder. Hidden files are left out.
std::vector<std::string> files_in(const std::filesystem::path& folder,
                                  const std::vector<std::string>& extensions);

// Endings of files that hold images, and of those that may hold depth.
const std::vector<std::string>& image_extensions();
const std::vector<std::string>& depth_extensions();

// The ending in small letters: ".png".
std::string extension_of(const std::filesystem::path& file);

// Capitals made small.
std::string lower_case(std::string text);

// A name without folder and ending: "rgb/12.5.png" -> "12.5".
std::string_view stem_of(std::string_view file);

// The number that the last run of digits in a name's stem makes: "frame-000012.color.png" -> 12. Empty where
// there is none.
std::optional<long> number_in(std::string_view file);

// The first of `names` that exists in the folder; empty where none does.
std::filesystem::path first_existing(const std::filesystem::path& folder,
                                     const std::vector<std::string>& names);

}  // namespace framewise
