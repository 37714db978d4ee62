// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/alignment_kernels.h"

#include <initializer_list>

#include "framewise/registration/lanes.h"

namespace framewise {
namespace {

constexpr int kLanesHere = 8;

// Columns of scratch space, each a row long.
struct Rows {
  float *qx, *qy, *qz;                                   // points in the reference's axes
  float *nx, *ny, *nz, *distance, *inverse, *precision;  // planes of their partners
  float* pulls[kPullColumns];
  int* partner;  // index of the pixel they fall on

  Rows(float* scratch, int width) {
    const int length = width + 16;
    for (float** row : {&qx, &qy, &qz, &nx, &ny, &nz, &distance, &inverse, &precision}) {
      *row = scratch;
      scratch += length;
    }
    for (float*& row : pulls) {
      row = scratch;
      scratch += length;
    }
    partner = reinterpret_cast<int*>(scratch);
  }
};

FRAMEWISE_INLINE void carry(const SurfaceView& reference, const SurfaceView& current, int v,
                            const MotionView& m, const Rows& rows) {
  const float* inverse_depth = current.inverse_depth + static_cast<long>(v) * current.width;
  const float y = (static_cast<float>(v) - current.cy) / current.fy;
  for (int u = 0; u < current.width; u += kLanesHere) {
    const Floats x = (counting_from(u) - current.cx) / current.fx;
    const Floats measured = load(inverse_depth + u);
    const Ints known = measured > 0;
    const Floats w = known ? measured : all(1);
    // All times w: it leaves the projection as it is.
    const Floats qx = m.R[0] * x + (m.R[1] * y + m.R[2]) + m.t[0] * w;
    const Floats qy = m.R[3] * x + (m.R[4] * y + m.R[5]) + m.t[1] * w;
    const Floats qz = m.R[6] * x + (m.R[7] * y + m.R[8]) + m.t[2] * w;
    const Ints ahead = qz > 1e-6f;
    const Floats inverse_z = 1 / (ahead ? qz : all(1));
    const Floats column = qx * inverse_z * reference.fx + (reference.cx + 0.5f);
    const Floats row = qy * inverse_z * reference.fy + (reference.cy + 0.5f);
    const Ints inside = known & ahead & (column >= 0) & (row >= 0) &
                        (column < static_cast<float>(reference.width)) &
                        (row < static_cast<float>(reference.height));
    const Ints i = __builtin_convertvector(where(inside, row), Ints) * reference.width +
                   __builtin_convertvector(where(inside, column), Ints);
    store(inside ? i : Ints{} - 1, rows.partner + u);
    const Floats z = 1 / w;
    store(qx * z, rows.qx + u);
    store(qy * z, rows.qy + u);
    store(qz * z, rows.qz + u);
  }
}

FRAMEWISE_INLINE void meet_partners(const SurfaceView& reference, int width, const Rows& rows) {
  for (int u = 0; u < width; ++u) {
    const int i = rows.partner[u] < 0 ? 0 : rows.partner[u];
    rows.nx[u] = reference.nx[i];
    rows.ny[u] = reference.ny[i];
    rows.nz[u] = reference.nz[i];
    rows.distance[u] = reference.distance[i];
    rows.inverse[u] = reference.inverse_depth[i];
    rows.precision[u] = rows.partner[u] < 0 ? 0.0f : reference.precision[i];
  }
}

// Square root of the weight that a residual of e standard deviations keeps.
template <PullLoss loss>
FRAMEWISE_INLINE Floats root_weight(const Floats& e, float threshold) {
  const Floats size = e < 0 ? -e : e;
  const Ints within = size < threshold;
  if constexpr (loss == PullLoss::kHuber)
    return within ? all(1) : square_root(threshold / (within ? all(1) : size));
  if constexpr (loss == PullLoss::kCauchy) return 1 / square_root(1 + e * e * (1 / (threshold * threshold)));
  if constexpr (loss == PullLoss::kTruncated) return where(within, all(1));
  if constexpr (loss == PullLoss::kTukey) return where(within, 1 - e * e * (1 / (threshold * threshold)));
  return all(1);
}

struct Counts {
  Floats partners{}, inliers{}, weight{}, squares{};
};

template <PullLoss loss>
FRAMEWISE_INLINE Counts pull(const SurfaceView& current, int v, const MotionView& m,
                             const PullOptions& options, const Rows& rows) {
  const long start = static_cast<long>(v) * current.width;
  const float narrowing = 1 / options.widening;
  Counts counts;
  for (int u = 0; u < current.width; u += kLanesHere) {
    const Floats qx = load(rows.qx + u), qy = load(rows.qy + u), qz = load(rows.qz + u);
    const Floats nx = load(rows.nx + u), ny = load(rows.ny + u), nz = load(rows.nz + u);
    const Floats cx = load(current.nx + start + u), cy = load(current.ny + start + u),
                 cz = load(current.nz + start + u);
    const Floats cosine = nx * (m.R[0] * cx + m.R[1] * cy + m.R[2] * cz) +
                          ny * (m.R[3] * cx + m.R[4] * cy + m.R[5] * cz) +
                          nz * (m.R[6] * cx + m.R[7] * cy + m.R[8] * cz);
    const Floats precision = load(rows.precision + u);
    const Floats ratio = qz * load(rows.inverse + u) - 1;
    const Ints last = counting_from(u) < static_cast<float>(current.width);
    const Ints together = last & (precision > 0) & (load(current.precision + start + u) > 0) &
                          (cosine > options.normal_cosine) & (ratio < options.depth_gate) &
                          (ratio > -options.depth_gate);
    const Floats s = where(together, precision) * narrowing;
    const Floats e = where(together, (nx * qx + ny * qy + nz * qz - load(rows.distance + u)) * s);
    const Floats root = root_weight<loss>(e, options.threshold);
    const Floats scale = s * root;
    const Ints inlier = together & ((e < 0 ? -e : e) < options.threshold);
    counts.partners += where(together, all(1));
    counts.inliers += where(inlier, all(1));
    counts.weight += where(together, root * root);
    counts.squares += where(inlier, e * e);
    const auto keep = [&](const Floats& column, int k) { store(where(together, column), rows.pulls[k] + u); };
    keep((qy * nz - qz * ny) * scale, 0);
    keep((qz * nx - qx * nz) * scale, 1);
    keep((qx * ny - qy * nx) * scale, 2);
    keep(nx * scale, 3);
    keep(ny * scale, 4);
    keep(nz * scale, 5);
    keep(e * root, 6);
  }
  return counts;
}

FRAMEWISE_INLINE double sum_of(const Floats& lanes) {
  double sum = 0;
  for (int k = 0; k < kLanesHere; ++k) sum += static_cast<double>(lanes[k]);
  return sum;
}

FRAMEWISE_INLINE void add_products(const Rows& rows, int width, PullSums& sums) {
  double* product = sums.products;
  for (int i = 0; i < kPullColumns; ++i)
    for (int j = i; j < kPullColumns; ++j, ++product) {
      Floats sum{};
      for (int u = 0; u < width; u += kLanesHere) sum += load(rows.pulls[i] + u) * load(rows.pulls[j] + u);
      *product += sum_of(sum);
    }
}

FRAMEWISE_INLINE Counts pull_by(const SurfaceView& current, int v, const MotionView& m,
                                const PullOptions& options, const Rows& rows) {
  switch (options.loss) {
    case PullLoss::kHuber:
      return pull<PullLoss::kHuber>(current, v, m, options, rows);
    case PullLoss::kCauchy:
      return pull<PullLoss::kCauchy>(current, v, m, options, rows);
    case PullLoss::kTruncated:
      return pull<PullLoss::kTruncated>(current, v, m, options, rows);
    case PullLoss::kTukey:
      return pull<PullLoss::kTukey>(current, v, m, options, rows);
    default:
      return pull<PullLoss::kTrivial>(current, v, m, options, rows);
  }
}

}  // namespace

FRAMEWISE_CHOSEN_AT_RUN_TIME
void add_pull_of_row(const SurfaceView& reference, const SurfaceView& current, int v,
                     const MotionView& motion, const PullOptions& options, float* scratch, PullSums& sums) {
  const Rows rows(scratch, current.width);
  carry(reference, current, v, motion, rows);
  meet_partners(reference, current.width, rows);
  const Counts counts = pull_by(current, v, motion, options, rows);
  sums.partners += sum_of(counts.partners);
  sums.inliers += sum_of(counts.inliers);
  sums.weight += sum_of(counts.weight);
  sums.squares += sum_of(counts.squares);
  add_products(rows, current.width, sums);
}

}  // namespace framewise
