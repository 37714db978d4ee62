// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/registration_kernels.h"

#include <limits>

#include "framewise/image/chosen_at_run_time.h"

namespace framewise {
namespace {

// The least whole number that is not below x, for x of [0, size].
FRAMEWISE_INLINE std::int32_t ceiling(double x) {
  const auto whole = static_cast<std::int32_t>(x);
  return whole + (static_cast<double>(whole) < x ? 1 : 0);
}

FRAMEWISE_INLINE double clamped(double x, double size) {
  const double above = x > 0 ? x : 0;  // NaN is none
  return above < size ? above : size;
}

}  // namespace

FRAMEWISE_CHOSEN_AT_RUN_TIME
void patches_of_row(const CornerRow& upper, const CornerRow& lower, const float* depth, int width,
                    const PatchView& view, const PatchRow& patches) {
  const double *x1 = upper.x, *y1 = upper.y, *z1 = upper.z;
  const double *x2 = lower.x + 1, *y2 = lower.y + 1, *z2 = lower.z + 1;
  const double fx = view.fx, fy = view.fy, cx = view.cx, cy = view.cy;
  const double tx = view.t[0], ty = view.t[1], tz = view.t[2];
  const double columns = view.width, rows = view.height;
  std::int32_t* __restrict left = patches.left;
  std::int32_t* __restrict right = patches.right;
  std::int32_t* __restrict top = patches.top;
  std::int32_t* __restrict bottom = patches.bottom;
  float* __restrict z_in_cam = patches.z;
#pragma GCC ivdep
  for (int u = 0; u < width; ++u) {
    const double z = depth[u];
    const double za = z * z1[u] + tz, zb = z * z2[u] + tz;
    const double ua = fx * (z * x1[u] + tx) / za + cx, ub = fx * (z * x2[u] + tx) / zb + cx;
    const double va = fy * (z * y1[u] + ty) / za + cy, vb = fy * (z * y2[u] + ty) / zb + cy;
    const double u_low = ua < ub ? ua : ub, u_high = ua < ub ? ub : ua;
    const double v_low = va < vb ? va : vb, v_high = va < vb ? vb : va;
    // Bitwise, so that there is no branch: comparisons with NaN are false.
    const int is_seen = (z > 0) & (z <= std::numeric_limits<float>::max()) & (za > 0) & (zb > 0) &
                        (u_high - u_low <= kWidestPatch_px) & (v_high - v_low <= kWidestPatch_px);
    const double keep = is_seen ? 1.0 : 0.0;
    left[u] = ceiling(clamped(u_low, columns) * keep);
    right[u] = ceiling(clamped(u_high, columns) * keep);
    top[u] = ceiling(clamped(v_low, rows) * keep);
    bottom[u] = ceiling(clamped(v_high, rows) * keep);
    z_in_cam[u] = static_cast<float>(0.5 * (za + zb));
  }
}

}  // namespace framewise
