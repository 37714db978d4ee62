// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace framewise {

// Throws std::invalid_argument that names an option of this room, what was found and what was expected.
inline void check_option(bool holds, const char* field, double found, const char* expected) {
  if (!holds)
    throw std::invalid_argument(std::string(field) + ": found " + std::to_string(found) + ", expected " +
                                expected);
}

}  // namespace framewise
