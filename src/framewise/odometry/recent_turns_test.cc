// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/recent_turns.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

const Eigen::Vector3d kRate(0.2, -0.5, 1.0);  // rad/s

Eigen::Matrix3d turned(double seconds) { return so3_exp(seconds * kRate); }

Eigen::Vector3d rate_after(const RecentTurns& turns, double stamp_before, double stamp) {
  return turns.rate(turned(-0.1), turned(0.9), stamp_before, stamp);
}

TEST(RecentTurns, ASteadyTurnHasItsRate) {
  RecentTurns turns;
  EXPECT_LT((rate_after(turns, 0.9, 1.0) - kRate).norm(), 1e-12);
  for (const double time : {0.6, 0.7, 0.8, 0.9}) turns.add(time, turned(time));
  EXPECT_LT((rate_after(turns, 0.9, 1.0) - kRate).norm(), 1e-12);
}

TEST(RecentTurns, AStampThatJittersHardlyChangesTheRate) {
  RecentTurns turns;
  for (const double time : {0.7, 0.8, 0.9}) turns.add(time, turned(time));
  const double jitter = 0.05;
  const double alone = (rate_after(RecentTurns(), 0.9, 1.0 - jitter) - kRate).norm();
  EXPECT_LT((rate_after(turns, 0.9, 1.0 - jitter) - kRate).norm(), 0.4 * alone);
}

TEST(RecentTurns, StampsThatStandOrRunBackwardsTellNoRate) {
  RecentTurns turns;
  turns.add(0.9, turned(0.9));
  EXPECT_EQ(rate_after(turns, 0.9, 0.9).norm(), 0);
  EXPECT_EQ(rate_after(turns, 0.9, 0.8).norm(), 0);
}

}  // namespace
}  // namespace framewise
