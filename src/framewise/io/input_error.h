// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace framewise {

// A file that cannot be used, in one line: path, line or field, what was found, what was expected.
class InputError : public std::runtime_error {
 public:
  InputError(const std::filesystem::path& path, const std::string& where, const std::string& found,
             const std::string& expected)
      : std::runtime_error(path.string() + (where.empty() ? "" : ": " + where) + ": found " + found + ", expected " +
                           expected) {}
};

}  // namespace framewise
