// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/box_hessian.h"

// No OpenCV and no Eigen in this file: code compiled for newer processors must not leak into shared inlines.
#if defined(__x86_64__) && defined(__GNUC__)
// AVX2 without fused multiply-add, which rounds differently.
#define FRAMEWISE_CHOSEN_AT_RUN_TIME __attribute__((target_clones("avx2", "default")))
#define FRAMEWISE_INLINE inline __attribute__((always_inline))
#else
#define FRAMEWISE_CHOSEN_AT_RUN_TIME
#define FRAMEWISE_INLINE inline
#endif

namespace framewise {
namespace {

// The rows of sums that the filters' edges touch, from the column of the filters' centre on.
struct FilterRows {
  int half, lobe, half_lobe;
  float per_pixel;
  const std::uint32_t *yy_top, *yy_lobe_top, *yy_lobe_bottom, *yy_bottom;
  const std::uint32_t *xx_top, *xx_bottom;
  const std::uint32_t *xy_top, *xy_above, *xy_below, *xy_bottom;
};

FRAMEWISE_INLINE FilterRows filter_rows(Sums sums, int filter, int x, int y) {
  const int half = filter / 2, lobe = filter / 3, half_lobe = lobe / 2;
  const auto row = [&](int dy) { return sums.data + (y + dy) * sums.stride + x; };
  return {half,
          lobe,
          half_lobe,
          1.0f / static_cast<float>(filter * filter),
          row(-half),
          row(-half_lobe),
          row(half_lobe + 1),
          row(half + 1),
          row(1 - lobe),
          row(lobe),
          row(-lobe),
          row(0),
          row(1),
          row(lobe + 1)};
}

// Sum of columns [left, right) between two rows of sums. Modulo 2^32, so exact however large the image is.
FRAMEWISE_INLINE std::int32_t box(const std::uint32_t* top, const std::uint32_t* bottom, int left,
                                  int right) {
  return static_cast<std::int32_t>(bottom[right] - bottom[left] - top[right] + top[left]);
}

FRAMEWISE_INLINE BoxDerivatives derivatives(const FilterRows& r, int x) {
  const int yy_left = x + 1 - r.lobe, yy_right = x + r.lobe;
  const std::int32_t yy = box(r.yy_top, r.yy_bottom, yy_left, yy_right) -
                          3 * box(r.yy_lobe_top, r.yy_lobe_bottom, yy_left, yy_right);
  const std::int32_t xx = box(r.xx_top, r.xx_bottom, x - r.half, x + r.half + 1) -
                          3 * box(r.xx_top, r.xx_bottom, x - r.half_lobe, x + r.half_lobe + 1);
  const std::int32_t xy =
      box(r.xy_top, r.xy_above, x - r.lobe, x) - box(r.xy_top, r.xy_above, x + 1, x + r.lobe + 1) -
      box(r.xy_below, r.xy_bottom, x - r.lobe, x) + box(r.xy_below, r.xy_bottom, x + 1, x + r.lobe + 1);
  return {static_cast<float>(xx) * r.per_pixel, static_cast<float>(yy) * r.per_pixel,
          static_cast<float>(xy) * r.per_pixel};
}

template <int kStep>
FRAMEWISE_INLINE void determinant_row(const FilterRows& rows, int n, float* determinants) {
  for (int i = 0; i < n; ++i) {
    const auto [xx, yy, xy] = derivatives(rows, kStep * i);
    determinants[i] = xx * yy - 0.81f * (xy * xy);
  }
}

}  // namespace

BoxDerivatives box_derivatives(Sums sums, int filter, int x, int y) {
  return derivatives(filter_rows(sums, filter, x, y), 0);
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void box_hessian_row(Sums sums, int filter, int x, int y, int step, int n, float* determinants) {
  const FilterRows rows = filter_rows(sums, filter, x, y);
  switch (step) {
    case 1:
      return determinant_row<1>(rows, n, determinants);
    case 2:
      return determinant_row<2>(rows, n, determinants);
    case 4:
      return determinant_row<4>(rows, n, determinants);
    default:
      return determinant_row<8>(rows, n, determinants);
  }
}

}  // namespace framewise
