// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/features/matching_neighbours.h"

namespace framewise {

// Two sets laid out for the kernels, see matching_blocks.h.
class BlockDistances {
 public:
  BlockDistances(const DescriptorPair& pair, Instructions instructions);

  AllPairs all_pairs() const;

  // Distances of row i of set 1 to the rows of set 2 from first_block * kBlockRows on: block_count *
  // kBlockRows.
  void to_blocks(int i, int first_block, int block_count, Key* keys) const;

 private:
  cv::Mat rows1_, blocks2_;  // CV_32S
  int n2_ = 0;
  BlockKernel kernel_ = nullptr;
};

// Exact nearest neighbours by looking at every pair; those of set2 where both_ways.
Neighbours exact_neighbours(const DescriptorPair& pair, bool both_ways, Instructions instructions);

}  // namespace framewise
