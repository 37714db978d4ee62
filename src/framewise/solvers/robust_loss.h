// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// How much a residual may pull: the price rho(q) of q = r' Sigma^-1 r, its squared length in standard
// deviations, and the weight rho'(q) it keeps in the normal equations. Near 0 all are rho = q.
enum class Loss {
  kTrivial,    // q: least squares
  kHuber,      // 2 T sqrt(q) - T^2 beyond T
  kCauchy,     // T^2 log(1 + q / T^2)
  kTruncated,  // T^2 beyond T
  kTukey       // T^2 / 3 (1 - (1 - q / T^2)^3), T^2 / 3 beyond T: truncated, but smooth
};

struct RobustLoss {
  Loss kind = Loss::kTrivial;
  double threshold = 3;  // T, standard deviations

  double price(double q) const;
  double weight(double q) const;
};

}  // namespace framewise
