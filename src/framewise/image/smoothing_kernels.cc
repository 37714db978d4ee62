// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/smoothing_kernels.h"

#include <limits>

#include "framewise/image/chosen_at_run_time.h"

namespace framewise {
namespace {

// Adds up to eight rows in one sweep, so that the sum is loaded and stored once for all of them.
template <int count, bool first, typename T>
FRAMEWISE_INLINE void sweep(const T* const* rows, int width, T* __restrict sum) {
  const T* row[8];
  for (int k = 0; k < count; ++k) row[k] = rows[k];
#pragma GCC ivdep
  for (int u = 0; u < width; ++u) {
    T s = first ? row[0][u] : static_cast<T>(sum[u] + row[0][u]);
    for (int k = 1; k < count; ++k) s = static_cast<T>(s + row[k][u]);
    sum[u] = s;
  }
}

template <bool first, typename T>
FRAMEWISE_INLINE void sweep_some(const T* const* rows, int count, int width, T* sum) {
  switch (count) {
    case 1:
      return sweep<1, first>(rows, width, sum);
    case 2:
      return sweep<2, first>(rows, width, sum);
    case 3:
      return sweep<3, first>(rows, width, sum);
    case 4:
      return sweep<4, first>(rows, width, sum);
    case 5:
      return sweep<5, first>(rows, width, sum);
    case 6:
      return sweep<6, first>(rows, width, sum);
    case 7:
      return sweep<7, first>(rows, width, sum);
    default:
      return sweep<8, first>(rows, width, sum);
  }
}

template <typename T>
FRAMEWISE_INLINE void sum_all(const T* const* rows, int count, int width, T* sum) {
  sweep_some<true>(rows, count, width, sum);
  for (int done = 8; done < count; done += 8) sweep_some<false>(rows + done, count - done, width, sum);
}

template <typename T>
FRAMEWISE_INLINE void grow(const T* added, const T* suffix, bool first, int width, T* __restrict prefix,
                           T* __restrict sum) {
  if (first) {
    for (int u = 0; u < width; ++u) {
      prefix[u] = added[u];
      sum[u] = added[u] + suffix[u];
    }
  } else {
    for (int u = 0; u < width; ++u) {
      const T grown = prefix[u] + added[u];
      prefix[u] = grown;
      sum[u] = grown + suffix[u];
    }
  }
}

}  // namespace

FRAMEWISE_CHOSEN_AT_RUN_TIME
void invert_depths(const float* depth, int width, float* __restrict value, float* __restrict centre,
                   std::uint16_t* __restrict weight) {
  constexpr float kFarthest = std::numeric_limits<float>::max();
  for (int u = 0; u < width; ++u) {
    const float z = depth[u], inverse = 1 / z;
    value[u] = centre[u] = z > 0 && z <= kFarthest ? inverse : 0.0f;
  }
  for (int u = 0; u < width; ++u) weight[u] = value[u] > 0 ? 1 : 0;
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void sum_rows(const float* const* rows, int count, int width, float* sum) {
  sum_all(rows, count, width, sum);
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void sum_rows(const std::uint16_t* const* rows, int count, int width, std::uint16_t* sum) {
  sum_all(rows, count, width, sum);
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void grow_window(const float* added, const float* suffix, bool first, int width, float* prefix, float* sum) {
  grow(added, suffix, first, width, prefix, sum);
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void grow_window(const std::int32_t* added, const std::int32_t* suffix, bool first, int width,
                 std::int32_t* prefix, std::int32_t* sum) {
  grow(added, suffix, first, width, prefix, sum);
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void add_row(const float* other, int width, float* __restrict row) {
  for (int u = 0; u < width; ++u) row[u] += other[u];
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void add_row(const std::int32_t* other, int width, std::int32_t* __restrict row) {
  for (int u = 0; u < width; ++u) row[u] += other[u];
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void widen(const std::uint16_t* narrow, int width, std::int32_t* wide) {
#pragma GCC ivdep
  for (int u = 0; u < width; ++u) wide[u] = narrow[u];
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void normalise(const float* value, const std::int32_t* weight, const float* centre, std::int32_t enough,
               int width, float* out) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
#pragma GCC ivdep
  for (int u = 0; u < width; ++u) {
    const float mean = value[u] / static_cast<float>(weight[u]);
    out[u] = (centre[u] > 0) | (weight[u] >= enough) ? mean : kUnknown;
  }
}

}  // namespace framewise
