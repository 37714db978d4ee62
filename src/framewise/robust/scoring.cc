// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/scoring.h"

#include <cmath>

// Vectors wider than the machine's calling convention knows are only passed to functions that are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"
#define FRAMEWISE_INLINE inline __attribute__((always_inline))

namespace framewise {
namespace {

constexpr std::size_t kBlock = 4 * Columns::kLanes;  // rows between two looks at whether to give up

// rho(s) of the marginalised price, s = r / T, as a polynomial: the header has the integral it stands for.
// Fitted by least squares with rho(0) = 0, rho(1) = 1; the error is below 2.2e-3.
constexpr float kRho2 = 7.5824089f, kRho3 = -13.0621406f, kRho4 = 8.3326217f, kRho5 = -1.8528900f;

inline float inverse_square(double T) { return static_cast<float>(1 / (T * T)); }

// When to stop looking at the rest of the rows: see Judge.
class GiveUp {
 public:
  explicit GiveUp(const Judge& judge)
      : cost_bound_(judge.cost_bound), log_hopeless_(std::log(judge.hopeless_odds)) {
    if (judge.good_share <= judge.bad_share) return;
    log_inlier_ = std::log(judge.bad_share / judge.good_share);
    log_outlier_ = std::log((1 - judge.bad_share) / (1 - judge.good_share));
  }
  bool now(const Tally& sum, std::size_t rows) const {
    const double in = static_cast<double>(sum.inliers), out = static_cast<double>(rows) - in;
    return sum.cost > cost_bound_ || in * log_inlier_ + out * log_outlier_ > log_hopeless_;
  }

 private:
  double cost_bound_, log_hopeless_, log_inlier_ = 0, log_outlier_ = 0;
};

using ScoreLoop = Tally (*)(const Columns&, const double*, const double*, const Judge&);
struct ScoringLoops {
  ScoreLoop sampson_plane, sampson_sphere, triangulated, distance, projection_plane, projection_sphere;
};

namespace portable {
#define FRAMEWISE_WIDTH 4
#include "framewise/robust/scoring_loops.inc"
#undef FRAMEWISE_WIDTH
}  // namespace portable

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
#define FRAMEWISE_WIDTH 8
#include "framewise/robust/scoring_loops.inc"
#undef FRAMEWISE_WIDTH
}  // namespace avx2
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#define FRAMEWISE_WIDTH 16
#include "framewise/robust/scoring_loops.inc"
#undef FRAMEWISE_WIDTH
}  // namespace avx512
#pragma GCC pop_options

const ScoringLoops& choose_loops() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")) {
    return avx512::kLoops;
  }
  return __builtin_cpu_supports("avx2") ? avx2::kLoops : portable::kLoops;
}
#else
const ScoringLoops& choose_loops() { return portable::kLoops; }
#endif

const ScoringLoops& loops() {
  static const ScoringLoops& chosen = choose_loops();
  return chosen;
}

}  // namespace

Tally score_sampson_plane(const Columns& columns, const double* E, const Judge& judge) {
  return loops().sampson_plane(columns, E, nullptr, judge);
}
Tally score_sampson_sphere(const Columns& columns, const double* E, const Judge& judge) {
  return loops().sampson_sphere(columns, E, nullptr, judge);
}
Tally score_triangulated(const Columns& columns, const double* R, const double* t, const Judge& judge) {
  return loops().triangulated(columns, R, t, judge);
}
Tally score_distance(const Columns& columns, const double* R, const double* t, const Judge& judge) {
  return loops().distance(columns, R, t, judge);
}
Tally score_projection_plane(const Columns& columns, const double* R, const double* t, const Judge& judge) {
  return loops().projection_plane(columns, R, t, judge);
}
Tally score_projection_sphere(const Columns& columns, const double* R, const double* t, const Judge& judge) {
  return loops().projection_sphere(columns, R, t, judge);
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
