// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>

namespace framewise {

// A folder to write to, made where it is missing, and a file in it, emptied. Both throw InputError naming
// what cannot be written; `option` is what the user chose it by.
void make_output_folder(const std::filesystem::path& folder, const char* option);
std::ofstream open_output_file(const std::filesystem::path& file, const char* option);

}  // namespace framewise
