// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/robust_loss.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

constexpr Loss kLosses[] = {Loss::kTrivial, Loss::kHuber, Loss::kCauchy, Loss::kTruncated, Loss::kTukey};

TEST(RobustLoss, WeightIsTheDerivativeOfThePrice) {
  for (const Loss kind : kLosses)
    for (const double q : {0.0, 0.5, 3.9, 4.1, 100.0}) {
      const RobustLoss loss{kind, 2};
      const double h = 1e-6;
      EXPECT_NEAR((loss.price(q + h) - loss.price(q)) / h, loss.weight(q + h / 2), 1e-7)
          << int(kind) << " " << q;
    }
}

TEST(RobustLoss, NearZeroAllAreLeastSquares) {
  for (const Loss kind : kLosses) {
    EXPECT_NEAR((RobustLoss{kind, 2}.price(1e-6)), 1e-6, 1e-12);
    EXPECT_EQ((RobustLoss{kind, 2}.weight(0)), 1);
  }
}

TEST(RobustLoss, FarPointsOfTruncatedAndTukeyPullNowhere) {
  EXPECT_EQ((RobustLoss{Loss::kTruncated, 2}.weight(4.1)), 0);
  EXPECT_EQ((RobustLoss{Loss::kTukey, 2}.weight(4.1)), 0);
}

}  // namespace
}  // namespace framewise
