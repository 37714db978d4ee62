// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/robust_loss.h"

#include <cmath>

namespace framewise {

double RobustLoss::price(double q) const {
  const double T = threshold, T2 = T * T, rest = q < T2 ? 1 - q / T2 : 0;
  switch (kind) {
    case Loss::kHuber:
      return q > T2 ? 2 * T * std::sqrt(q) - T2 : q;
    case Loss::kCauchy:
      return T2 * std::log1p(q / T2);
    case Loss::kTruncated:
      return q < T2 ? q : T2;
    case Loss::kTukey:
      return T2 / 3 * (1 - rest * rest * rest);
    case Loss::kTrivial:
      break;
  }
  return q;
}

double RobustLoss::weight(double q) const {
  const double T = threshold, T2 = T * T, rest = q < T2 ? 1 - q / T2 : 0;
  switch (kind) {
    case Loss::kHuber:
      return q > T2 ? T / std::sqrt(q) : 1;
    case Loss::kCauchy:
      return T2 / (T2 + q);
    case Loss::kTruncated:
      return q < T2 ? 1 : 0;
    case Loss::kTukey:
      return rest * rest;
    case Loss::kTrivial:
      break;
  }
  return 1;
}

}  // namespace framewise
