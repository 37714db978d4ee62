// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching_nearest.h"

#include <algorithm>
#include <climits>

namespace framewise {
namespace {

// No OpenCV and no Eigen in this file: code compiled for newer processors must not leak into shared inlines.
#if defined(__x86_64__) && defined(__GNUC__)
#define FRAMEWISE_AVX2 __attribute__((target("avx2")))
#endif
#define FRAMEWISE_INLINE inline __attribute__((always_inline))

// As many blocks at a time as stay in the first-level cache while all rows of the first set pass by.
constexpr int kTileBytes = 24 * 1024;
constexpr int kMaxTileRows = 512;

FRAMEWISE_INLINE Key smallest(const Key* keys, int n) {
  Key least = INT_MAX;
  for (int j = 0; j < n; ++j) least = keys[j] < least ? keys[j] : least;
  return least;
}

FRAMEWISE_INLINE void update_second_set(const Key* keys, int n, int row, Key* best, int* index) {
  for (int j = 0; j < n; ++j) {
    const bool nearer = keys[j] < best[j];
    best[j] = nearer ? keys[j] : best[j];
    index[j] = nearer ? row : index[j];
  }
}

FRAMEWISE_INLINE void update_first_set(Key* keys, int n, int first, Nearest& nearest) {
  const Key least = smallest(keys, n);
  if (least >= nearest.second) return;
  if (least >= nearest.key) {
    nearest.second = least;
    return;
  }
  int j = 0;
  while (keys[j] != least) ++j;
  keys[j] = INT_MAX;
  nearest.second = std::min(nearest.key, smallest(keys, n));
  nearest.key = least;
  nearest.index = first + j;
}

FRAMEWISE_INLINE void search(const AllPairs& pairs, Nearest* nearest1, const NearestOfSecond* nearest2) {
  const std::int64_t block_cells = static_cast<std::int64_t>(pairs.cells) * kBlockRows;
  const int tile_blocks =
      std::clamp(static_cast<int>(kTileBytes / (block_cells * 4)), 1, kMaxTileRows / kBlockRows);
  const int tile_rows = tile_blocks * kBlockRows;
  alignas(64) Key keys[kMaxTileRows];
  for (int first = 0; first < pairs.n2; first += tile_rows) {
    const int n = std::min(tile_rows, pairs.n2 - first);
    const std::int32_t* tile = pairs.blocks2 + first / kBlockRows * block_cells;
    for (int i = 0; i < pairs.n1; ++i) {
      pairs.kernel(pairs.rows1 + i * pairs.stride1, tile, pairs.cells, (n + kBlockRows - 1) / kBlockRows,
                   keys);
      if (nearest2) update_second_set(keys, n, i, nearest2->keys + first, nearest2->indices + first);
      update_first_set(keys, n, first, nearest1[i]);
    }
  }
}

#ifdef FRAMEWISE_AVX2
FRAMEWISE_AVX2 void search_avx2(const AllPairs& pairs, Nearest* nearest1, const NearestOfSecond* nearest2) {
  search(pairs, nearest1, nearest2);
}
#endif

}  // namespace

Instructions best_instructions() {
#ifdef FRAMEWISE_AVX2
  if (__builtin_cpu_supports("avx2")) return Instructions::kAvx2;
#endif
  return Instructions::kPortable;
}

void find_nearest(const AllPairs& pairs, [[maybe_unused]] Instructions instructions, Nearest* nearest1,
                  const NearestOfSecond* nearest2) {
#ifdef FRAMEWISE_AVX2
  if (instructions == Instructions::kAvx2) return search_avx2(pairs, nearest1, nearest2);
#endif
  search(pairs, nearest1, nearest2);
}

}  // namespace framewise
