// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/hamming.h"

#include <bit>
#include <cstring>

// No OpenCV and no Eigen in this file: code compiled for newer processors must not leak into shared inlines.
#if defined(__x86_64__) && defined(__GNUC__)
#define FRAMEWISE_CHOSEN_AT_RUN_TIME __attribute__((target_clones("popcnt", "default")))
#else
#define FRAMEWISE_CHOSEN_AT_RUN_TIME
#endif

namespace framewise {

FRAMEWISE_CHOSEN_AT_RUN_TIME
void nearest_by_hamming(const std::uint8_t* rows1, int n1, const std::uint8_t* rows2, int n2, int words,
                        Nearest* nearest1, Nearest* nearest2) {
  const auto word = [words](const std::uint8_t* rows, int row, int k) {
    std::uint64_t value;
    std::memcpy(&value, rows + (static_cast<std::int64_t>(row) * words + k) * 8, 8);
    return value;
  };
  for (int i = 0; i < n1; ++i) {
    Nearest best = nearest1[i];
    for (int j = 0; j < n2; ++j) {
      int distance = 0;
      for (int k = 0; k < words; ++k) distance += std::popcount(word(rows1, i, k) ^ word(rows2, j, k));
      if (distance < best.distance) best = {j, distance};
      if (distance < nearest2[j].distance) nearest2[j] = {i, distance};
    }
    nearest1[i] = best;
  }
}

}  // namespace framewise
