// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/input_error.h"

#include <fmt/format.h>

namespace framewise {

InputError::InputError(const std::filesystem::path& path, std::size_t line, const std::string& field,
                       const std::string& found, const std::string& expected)
    : std::runtime_error(fmt::format("{}{}: {}{}found {}, expected {}", path.string(),
                                     line > 0 ? fmt::format(":{}", line) : "", field,
                                     field.empty() ? "" : ": ", found, expected)) {}

}  // namespace framewise
