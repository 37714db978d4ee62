// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace framewise {

struct ZipEntry {
  std::string name;
  std::string content;
};

// A zip archive of these entries in this order, stored as they are (no compression) and dated 1980-01-01, the
// format's first day: the same entries give the same bytes. The file appears when it is complete. Throws
// InputError where it cannot be written; `option` is what the user chose it by.
void write_zip(const std::filesystem::path& path, const std::vector<ZipEntry>& entries, const char* option);

}  // namespace framewise
