// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace framewise {

// What every solver of N points asks of its arguments: as many x2 as x1, and no weights or one for each.
inline void check_matching_sizes(const char* solver, std::size_t x1, std::size_t x2,
                                 std::size_t weights = 0) {
  if (x2 != x1)
    throw std::invalid_argument(std::string(solver) + ": x2 has " + std::to_string(x2) +
                                " bearings, expected as many as x1: " + std::to_string(x1));
  if (weights != 0 && weights != x1)
    throw std::invalid_argument(std::string(solver) + ": weights has " + std::to_string(weights) +
                                " values, expected none or as many as x1: " + std::to_string(x1));
}

}  // namespace framewise
