// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace framewise {

// How exact matching lays out descriptors. A descriptor is a row of 32-bit cells: four bytes of a binary one,
// a float, or two 16-bit integers. The second set is kept in blocks of 32 rows side by side, cell by cell
//   block[cell * 32 + row]
// so that a vector instruction works on as many rows as it has lanes and none ever adds up its own lanes.
// A row that fills up the last block is zeros.
constexpr int kBlockRows = 32;

// Distances as keys: integers that are ordered as the distances are. Hamming: the bits. L2: the squared
// distance as a float, read as an integer (floats that are not negative are ordered as their bits are).
using Key = std::int32_t;

// Distances of one row to each row of block_count blocks.
using BlockKernel = void (*)(const std::int32_t* row, const std::int32_t* blocks, int cells, int block_count,
                             Key* keys);

// Instructions a kernel may use. The keys are the same with all of them.
enum class Instructions { kPortable, kAvx2 };

// What this processor has.
Instructions best_instructions();

}  // namespace framewise
