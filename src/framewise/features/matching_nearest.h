// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <climits>

#include "framewise/features/matching_blocks.h"

namespace framewise {

// A descriptor's nearest in the other set, and how far the next one is that would do.
struct Nearest {
  int index = -1;
  Key key = INT_MAX;
  Key second = INT_MAX;

  // Another candidate, in any order.
  void see(int candidate, Key distance) {
    if (distance < key || (distance == key && candidate < index))
      second = key, key = distance, index = candidate;
    else if (distance < second)
      second = distance;
  }
};

// Every row of the first set against every row of the second.
struct AllPairs {
  BlockKernel kernel;
  const std::int32_t* rows1;  // stride1 cells apart
  std::int64_t stride1;
  int n1;
  const std::int32_t* blocks2;
  int n2;
  int cells;
};

// The first set's rows that are nearest to those of the second: keys[n2] come in as INT_MAX, indices[n2] as
// -1.
struct NearestOfSecond {
  Key* keys;
  int* indices;
};

// Fills nearest1[n1], which comes in default-constructed, and, unless null, nearest2. Ties go to the lower
// index.
void find_nearest(const AllPairs& pairs, Instructions instructions, Nearest* nearest1,
                  const NearestOfSecond* nearest2);

}  // namespace framewise
