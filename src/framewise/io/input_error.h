// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace framewise {

// A file that cannot be used: one line that names the file, the line (from 1; 0: the file as a whole), the
// field, what was found and what was expected.
//   runs/a.txt:12: qw: found 'abc', expected a number
class InputError : public std::runtime_error {
 public:
  InputError(const std::filesystem::path& path, std::size_t line, const std::string& field,
             const std::string& found, const std::string& expected);
};

}  // namespace framewise
