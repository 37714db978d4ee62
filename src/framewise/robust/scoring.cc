// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/scoring.h"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FRAMEWISE_EVERY_ISA __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FRAMEWISE_EVERY_ISA
#endif
#define FRAMEWISE_INLINE inline __attribute__((always_inline))

namespace framewise {
namespace {

constexpr std::size_t kLanes = Columns::kLanes;
constexpr std::size_t kBlock = 4 * kLanes;  // rows between two looks at whether to give up

// rho(s) of the marginalised price, s = r / T, as a polynomial: the header has the integral it stands for.
// Fitted by least squares with rho(0) = 0, rho(1) = 1; the error is below 2.2e-3.
constexpr float kRho2 = 7.5824089f, kRho3 = -13.0621406f, kRho4 = 8.3326217f, kRho5 = -1.8528900f;

struct CountPrice {
  FRAMEWISE_INLINE static float of(float) { return 0; }
};
struct MsacPrice {
  FRAMEWISE_INLINE static float of(float q) { return q; }
};
struct MarginalisedPrice {
  FRAMEWISE_INLINE static float of(float q) {
    const float s = std::sqrt(q);
    return q * (kRho2 + s * (kRho3 + s * (kRho4 + s * kRho5)));
  }
};

// Sums `lane_price(q(row))` over all rows; `squared(row)` is the squared residual in units of T.
template <typename Price, typename Squared>
FRAMEWISE_INLINE Tally tally(const Columns& columns, const Judge& judge, const Squared& squared) {
  const double log_in = judge.good_share > judge.bad_share ? std::log(judge.bad_share / judge.good_share) : 0;
  const double log_out =
      judge.good_share > judge.bad_share ? std::log((1 - judge.bad_share) / (1 - judge.good_share)) : 0;
  const double log_hopeless = std::log(judge.hopeless_odds);
  const std::size_t rows = columns.rows(), padded = columns.padded_rows();

  Tally sum;
  for (std::size_t begin = 0; begin < padded; begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, padded);
    float cost[kLanes] = {}, inside[kLanes] = {};
    for (std::size_t i = begin; i < end; i += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const float q = squared(i + lane);
        const float p = Price::of(q);
        cost[lane] += q < 1.0f ? p : 1.0f;  // NaN, the filling, is outside
        inside[lane] += q < 1.0f ? 1.0f : 0.0f;
      }
    }
    float block_cost = 0, block_inside = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      block_cost += cost[lane];
      block_inside += inside[lane];
    }
    sum.cost += block_cost;
    sum.inliers += static_cast<std::size_t>(block_inside);
    if (end >= rows) break;
    const double in = static_cast<double>(sum.inliers);
    if (sum.cost > judge.cost_bound ||
        in * log_in + (static_cast<double>(end) - in) * log_out > log_hopeless) {
      sum.complete = false;
      return sum;
    }
  }
  sum.cost -= static_cast<double>(padded - rows);
  return sum;
}

template <typename Squared>
FRAMEWISE_INLINE Tally tally(const Columns& columns, const Judge& judge, const Squared& squared) {
  switch (judge.scoring) {
    case Scoring::kInlierCount:
      return tally<CountPrice>(columns, judge, squared);
    case Scoring::kMarginalised:
      return tally<MarginalisedPrice>(columns, judge, squared);
    case Scoring::kMsac:
      break;
  }
  return tally<MsacPrice>(columns, judge, squared);
}

struct Floats9 {
  explicit Floats9(const double* m) {
    for (int i = 0; i < 9; ++i) v[i] = static_cast<float>(m[i]);
  }
  float v[9];
};

FRAMEWISE_INLINE float inverse_square(double T) { return static_cast<float>(1 / (T * T)); }

}  // namespace

FRAMEWISE_EVERY_ISA Tally score_sampson_plane(const Columns& columns, const double* E, const Judge& judge) {
  const float *u1 = columns.column(0), *v1 = columns.column(1);
  const float *u2 = columns.column(2), *v2 = columns.column(3);
  const Floats9 m(E);
  const float e0 = m.v[0], e1 = m.v[1], e2 = m.v[2], e3 = m.v[3], e4 = m.v[4], e5 = m.v[5], e6 = m.v[6],
              e7 = m.v[7], e8 = m.v[8];
  const float scale = inverse_square(judge.max_error);
  return tally(columns, judge, [=](std::size_t i) {
    const float a = e0 * u1[i] + e1 * v1[i] + e2;  // E x1
    const float b = e3 * u1[i] + e4 * v1[i] + e5;
    const float c = e6 * u1[i] + e7 * v1[i] + e8;
    const float d = e0 * u2[i] + e3 * v2[i] + e6;  // E' x2
    const float e = e1 * u2[i] + e4 * v2[i] + e7;
    const float r = a * u2[i] + b * v2[i] + c;
    return scale * (r * r) / (a * a + b * b + d * d + e * e);
  });
}

FRAMEWISE_EVERY_ISA Tally score_sampson_sphere(const Columns& columns, const double* E, const Judge& judge) {
  const float *x1 = columns.column(0), *y1 = columns.column(1), *z1 = columns.column(2);
  const float *x2 = columns.column(3), *y2 = columns.column(4), *z2 = columns.column(5);
  const Floats9 m(E);
  const float e0 = m.v[0], e1 = m.v[1], e2 = m.v[2], e3 = m.v[3], e4 = m.v[4], e5 = m.v[5], e6 = m.v[6],
              e7 = m.v[7], e8 = m.v[8];
  const float scale = inverse_square(judge.max_error);
  return tally(columns, judge, [=](std::size_t i) {
    const float a = e0 * x1[i] + e1 * y1[i] + e2 * z1[i];  // E x1
    const float b = e3 * x1[i] + e4 * y1[i] + e5 * z1[i];
    const float c = e6 * x1[i] + e7 * y1[i] + e8 * z1[i];
    const float d = e0 * x2[i] + e3 * y2[i] + e6 * z2[i];  // E' x2
    const float e = e1 * x2[i] + e4 * y2[i] + e7 * z2[i];
    const float f = e2 * x2[i] + e5 * y2[i] + e8 * z2[i];
    const float r = a * x2[i] + b * y2[i] + c * z2[i];
    // The parts of both gradients that are tangent to the sphere.
    return scale * (r * r) / (a * a + b * b + c * c + d * d + e * e + f * f - 2.0f * (r * r));
  });
}

FRAMEWISE_EVERY_ISA Tally score_triangulated(const Columns& columns, const double* R, const double* t,
                                             const Judge& judge) {
  const float *x1 = columns.column(0), *y1 = columns.column(1), *z1 = columns.column(2);
  const float *x2 = columns.column(3), *y2 = columns.column(4), *z2 = columns.column(5);
  const Floats9 m(R);
  const float r0 = m.v[0], r1 = m.v[1], r2 = m.v[2], r3 = m.v[3], r4 = m.v[4], r5 = m.v[5], r6 = m.v[6],
              r7 = m.v[7], r8 = m.v[8];
  const float tx = static_cast<float>(t[0]), ty = static_cast<float>(t[1]), tz = static_cast<float>(t[2]);
  const float scale = inverse_square(judge.max_error);
  return tally(columns, judge, [=](std::size_t i) {
    const float fx = r0 * x1[i] + r1 * y1[i] + r2 * z1[i];  // f = R x1
    const float fy = r3 * x1[i] + r4 * y1[i] + r5 * z1[i];
    const float fz = r6 * x1[i] + r7 * y1[i] + r8 * z1[i];
    const float gx = x2[i], gy = y2[i], gz = z2[i];
    const float nx = gy * fz - gz * fy, ny = gz * fx - gx * fz, nz = gx * fy - gy * fx;  // g x f
    // Depths along the rays times |n|^2, from lambda1 f + t = lambda2 g crossed with g and f.
    const float lambda1 = (ty * gz - tz * gy) * nx + (tz * gx - tx * gz) * ny + (tx * gy - ty * gx) * nz;
    const float lambda2 = (ty * fz - tz * fy) * nx + (tz * fx - tx * fz) * ny + (tx * fy - ty * fx) * nz;
    const float n2 = nx * nx + ny * ny + nz * nz;
    // Twice the point midway, times |n|^2, seen from camera 2 (p) and from camera 1 (q), in camera 2's axes.
    const float ax = lambda1 * fx + lambda2 * gx, ay = lambda1 * fy + lambda2 * gy,
                az = lambda1 * fz + lambda2 * gz;
    const float px = ax + n2 * tx, py = ay + n2 * ty, pz = az + n2 * tz;
    const float qx = ax - n2 * tx, qy = ay - n2 * ty, qz = az - n2 * tz;
    const float cx = py * gz - pz * gy, cy = pz * gx - px * gz, cz = px * gy - py * gx;
    const float dx = qy * fz - qz * fy, dy = qz * fx - qx * fz, dz = qx * fy - qy * fx;
    const float sum = (cx * cx + cy * cy + cz * cz) / (px * px + py * py + pz * pz) +
                      (dx * dx + dy * dy + dz * dz) / (qx * qx + qy * qy + qz * qz);
    const bool front = lambda1 > 0.0f && lambda2 > 0.0f;
    return front ? scale * sum : 2.0f;
  });
}

FRAMEWISE_EVERY_ISA Tally score_distance(const Columns& columns, const double* R, const double* t,
                                         const Judge& judge) {
  const float *x1 = columns.column(0), *y1 = columns.column(1), *z1 = columns.column(2);
  const float *x2 = columns.column(3), *y2 = columns.column(4), *z2 = columns.column(5);
  const Floats9 m(R);
  const float r0 = m.v[0], r1 = m.v[1], r2 = m.v[2], r3 = m.v[3], r4 = m.v[4], r5 = m.v[5], r6 = m.v[6],
              r7 = m.v[7], r8 = m.v[8];
  const float tx = static_cast<float>(t[0]), ty = static_cast<float>(t[1]), tz = static_cast<float>(t[2]);
  const float scale = inverse_square(judge.max_error);
  return tally(columns, judge, [=](std::size_t i) {
    const float dx = r0 * x1[i] + r1 * y1[i] + r2 * z1[i] + tx - x2[i];
    const float dy = r3 * x1[i] + r4 * y1[i] + r5 * z1[i] + ty - y2[i];
    const float dz = r6 * x1[i] + r7 * y1[i] + r8 * z1[i] + tz - z2[i];
    return scale * (dx * dx + dy * dy + dz * dz);
  });
}

FRAMEWISE_EVERY_ISA Tally score_projection_plane(const Columns& columns, const double* R, const double* t,
                                                 const Judge& judge) {
  const float *x1 = columns.column(0), *y1 = columns.column(1), *z1 = columns.column(2);
  const float *u2 = columns.column(3), *v2 = columns.column(4);
  const Floats9 m(R);
  const float r0 = m.v[0], r1 = m.v[1], r2 = m.v[2], r3 = m.v[3], r4 = m.v[4], r5 = m.v[5], r6 = m.v[6],
              r7 = m.v[7], r8 = m.v[8];
  const float tx = static_cast<float>(t[0]), ty = static_cast<float>(t[1]), tz = static_cast<float>(t[2]);
  const float scale = inverse_square(judge.max_error);
  return tally(columns, judge, [=](std::size_t i) {
    const float px = r0 * x1[i] + r1 * y1[i] + r2 * z1[i] + tx;
    const float py = r3 * x1[i] + r4 * y1[i] + r5 * z1[i] + ty;
    const float pz = r6 * x1[i] + r7 * y1[i] + r8 * z1[i] + tz;
    const float dx = px - u2[i] * pz, dy = py - v2[i] * pz;
    const float q = scale * (dx * dx + dy * dy) / (pz * pz);
    return pz > 0.0f ? q : 2.0f;
  });
}

FRAMEWISE_EVERY_ISA Tally score_projection_sphere(const Columns& columns, const double* R, const double* t,
                                                  const Judge& judge) {
  const float *x1 = columns.column(0), *y1 = columns.column(1), *z1 = columns.column(2);
  const float *x2 = columns.column(3), *y2 = columns.column(4), *z2 = columns.column(5);
  const Floats9 m(R);
  const float r0 = m.v[0], r1 = m.v[1], r2 = m.v[2], r3 = m.v[3], r4 = m.v[4], r5 = m.v[5], r6 = m.v[6],
              r7 = m.v[7], r8 = m.v[8];
  const float tx = static_cast<float>(t[0]), ty = static_cast<float>(t[1]), tz = static_cast<float>(t[2]);
  const float scale = inverse_square(judge.max_error);
  return tally(columns, judge, [=](std::size_t i) {
    const float px = r0 * x1[i] + r1 * y1[i] + r2 * z1[i] + tx;
    const float py = r3 * x1[i] + r4 * y1[i] + r5 * z1[i] + ty;
    const float pz = r6 * x1[i] + r7 * y1[i] + r8 * z1[i] + tz;
    const float cx = py * z2[i] - pz * y2[i], cy = pz * x2[i] - px * z2[i], cz = px * y2[i] - py * x2[i];
    const float q = scale * (cx * cx + cy * cy + cz * cz) / (px * px + py * py + pz * pz);
    const float along = px * x2[i] + py * y2[i] + pz * z2[i];
    return along > 0.0f ? q : 2.0f;
  });
}

double price(double q, Scoring scoring) {
  if (!(q < 1)) return 1;
  switch (scoring) {
    case Scoring::kInlierCount:
      return 0;
    case Scoring::kMsac:
      return q;
    case Scoring::kMarginalised: {
      const double s = std::sqrt(q);
      return q * (kRho2 + s * (kRho3 + s * (kRho4 + s * kRho5)));
    }
  }
  return 1;
}

}  // namespace framewise
