// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/output_file.h"

#include <fmt/format.h>

#include "framewise/io/input_error.h"

namespace framewise {

namespace fs = std::filesystem;

void make_output_folder(const fs::path& folder, const char* option) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw InputError(folder, 0, "", "a path that is no folder",
                     fmt::format("a folder to write to ({})", option));
}

std::ofstream open_output_file(const fs::path& file, const char* option) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  if (!stream)
    throw InputError(file, 0, "", "a file that cannot be written",
                     fmt::format("a folder to write to ({})", option));
  return stream;
}

}  // namespace framewise
