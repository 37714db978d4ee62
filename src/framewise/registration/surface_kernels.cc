// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/surface_kernels.h"

#include "framewise/registration/lanes.h"

namespace framewise {
namespace {

// Sums over the pixels of a neighbourhood that belong to the surface of its centre; d is their inverse depth
// less the centre's.
struct Moments {
  Floats n{}, x{}, y{}, xx{}, xy{}, yy{}, d{}, xd{}, yd{};
};

FRAMEWISE_INLINE void add_row(const float* row, int reach, float dv, const Floats& centre,
                              const Floats& reach_in_depth, Moments& sums) {
  Floats n{}, x{}, xx{}, d{}, xd{};
  for (int i = -reach; i <= reach; ++i) {
    const float du = static_cast<float>(i);
    const Floats difference = load(row + i) - centre;
    const Ints same = (difference < reach_in_depth) & (difference > -reach_in_depth);
    const Floats one = where(same, all(1)), kept = where(same, difference);
    n += one;
    x += one * du;
    xx += one * (du * du);
    d += kept;
    xd += kept * du;
  }
  sums.n += n;
  sums.x += x;
  sums.xx += xx;
  sums.d += d;
  sums.xd += xd;
  sums.y += n * dv;
  sums.xy += x * dv;
  sums.yy += n * (dv * dv);
  sums.yd += d * dv;
}

// The normal equations in closed form; their entries are small whole numbers, so the determinant is exact.
FRAMEWISE_INLINE void solve(const Moments& m, const Floats& centre, float least, int u,
                            const FittedRow& out) {
  const Floats c00 = m.xx * m.yy - m.xy * m.xy, c01 = m.xy * m.y - m.x * m.yy, c02 = m.x * m.xy - m.xx * m.y;
  const Floats c11 = m.n * m.yy - m.y * m.y, c12 = m.x * m.y - m.n * m.xy, c22 = m.n * m.xx - m.x * m.x;
  const Floats determinant = m.n * c00 + m.x * c01 + m.y * c02;
  const Ints good = (m.n >= least) & (determinant > 0.5f);
  const Floats inverse = 1 / (determinant > 0.5f ? determinant : all(1));
  const Floats fitted = centre + (c00 * m.d + c01 * m.xd + c02 * m.yd) * inverse;
  store(where(good & (fitted > 0), fitted), out.inverse_depth + u);
  store((c01 * m.d + c11 * m.xd + c12 * m.yd) * inverse, out.slope_u + u);
  store((c02 * m.d + c12 * m.xd + c22 * m.yd) * inverse, out.slope_v + u);
  store(c11 * inverse, out.spread_u + u);
}

}  // namespace

FRAMEWISE_CHOSEN_AT_RUN_TIME
void halve_rows(const float* above, const float* below, int width, float tolerance, float* out) {
  for (int u = 0; u < width; ++u) {
    const float w[4] = {above[2 * u], above[2 * u + 1], below[2 * u], below[2 * u + 1]};
    const float nearest01 = w[0] > w[1] ? w[0] : w[1], nearest23 = w[2] > w[3] ? w[2] : w[3];
    const float nearest = nearest01 > nearest23 ? nearest01 : nearest23;
    float sum = 0, count = 0;
    for (int k = 0; k < 4; ++k) {
      const bool same = w[k] > nearest * (1 - tolerance);
      sum += same ? w[k] : 0.0f;
      count += same ? 1.0f : 0.0f;
    }
    out[u] = count > 0 ? sum / count : 0.0f;
  }
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void fit_planes(const float* const* rows, int reach, int width, float tolerance, float least,
                const FittedRow& out) {
  for (int u = 0; u < width; u += kLanes) {
    const Floats centre = load(rows[reach] + u);
    Moments sums;
    for (int j = -reach; j <= reach; ++j)
      add_row(rows[j + reach] + u, reach, static_cast<float>(j), centre, centre * tolerance, sums);
    solve(sums, centre, least, u, out);
  }
}

FRAMEWISE_CHOSEN_AT_RUN_TIME
void convert_planes(const FittedRow& fitted, const PlaneModel& model, int width, const PlaneRow& out) {
  for (int u = 0; u < width; u += kLanes) {
    const Floats x = (counting_from(u) - model.cx) / model.fx, y = all(model.y);
    const Floats measured = load(fitted.inverse_depth + u);
    const Ints known = measured > 0;
    const Floats w = known ? measured : all(1);
    const Floats A = load(fitted.slope_u + u) * model.fx, B = load(fitted.slope_v + u) * model.fy;
    const Floats C = w - A * x - B * y;
    const Floats distance = 1 / square_root(A * A + B * B + C * C);
    const Floats z = 1 / w, along = distance * w;  // n . ray
    const Floats cosine2 = along * along / (x * x + y * y + 1);
    const Floats beyond = z - model.noise_nearest;
    const Floats sigma_z = model.noise_floor + model.noise_growth * (beyond * beyond);
    const Floats forward = sigma_z * along, sideways = z * model.sideways;
    const Floats variance = 2 * (forward * forward) + 2 * (sideways * sideways) * (1 - cosine2);
    const Ints good = known & (cosine2 > model.least_cosine * model.least_cosine) & (variance > 0);
    const Floats precision2 = 1 / (good ? variance : all(1));
    // A component of n is distance x (A, B or C), of variance (fx sigma_w)^2 spread; sigma_w = sigma_z w^2.
    const Floats sigma_n = distance * model.fx * sigma_z * w * w;
    store(where(good, w), out.inverse_depth + u);
    store(A * distance, out.nx + u);
    store(B * distance, out.ny + u);
    store(C * distance, out.nz + u);
    store(distance, out.distance + u);
    store(where(good, square_root(precision2)), out.precision + u);
    store(where(good, precision2 * (sigma_n * sigma_n) * load(fitted.spread_u + u)), out.feigned + u);
  }
}

}  // namespace framewise
