// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace framewise {

struct Nearest {
  int index, distance;
};

// For every row of either set its nearest row in the other, by Hamming distance; ties to the lower index.
// Rows are `words` 64-bit words, packed; nearest1[n1] and nearest2[n2] come in as {-1, INT_MAX}.
// The instructions used are chosen when the program runs; the answer is the same with all of them.
void nearest_by_hamming(const std::uint8_t* rows1, int n1, const std::uint8_t* rows2, int n2, int words,
                        Nearest* nearest1, Nearest* nearest2);

}  // namespace framewise
