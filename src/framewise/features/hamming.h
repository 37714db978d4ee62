// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/features/matching_blocks.h"

namespace framewise {

// Hamming distances of blocks of binary descriptors. Four bytes take two cells: of each byte the lower four
// bits, then of each the upper four, so that a table of 16 entries counts them. Bytes beyond the last are
// zeros.
BlockKernel hamming_kernel(Instructions instructions);

// Hamming distances of one descriptor to those rows that are listed. Rows are `bytes` long and begin
// `stride` bytes apart.
void hamming_to_listed(const std::uint8_t* descriptor, const std::uint8_t* rows, std::int64_t stride,
                       int bytes, const int* listed, int count, Key* keys);

}  // namespace framewise
