// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/axis_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// A path and one that leaves it by 1 cm more along y at every pose, and is turned about z by 0.02 rad.
TrajectoryPair drifting(int count) {
  TrajectoryPair pair;
  for (int i = 0; i < count; ++i) {
    const Pose truth{so3_exp({0.1 * i, 0, 0}), Eigen::Vector3d(i, 2 * i, 0)};
    const Pose estimate{so3_exp({0, 0, 0.02}) * truth.R, truth.t - Eigen::Vector3d(0, 0.01 * i, 0)};
    pair.reference.add(i, truth);
    pair.estimate.add(i, estimate);
  }
  return pair;
}

TEST(AxisErrors, ADriftAlongOneAxisIsSeenThereAlone) {
  const AxisErrors errors = axis_errors(drifting(11));
  EXPECT_NEAR(errors.position[1].max, 0.1, 1e-12);
  EXPECT_NEAR(errors.position[1].mean, 0.05, 1e-12);
  EXPECT_NEAR(errors.position[1].min, 0, 1e-12);
  EXPECT_NEAR(errors.position[0].max, 0, 1e-12);
  EXPECT_NEAR(errors.position[2].max, 0, 1e-12);
  EXPECT_NEAR(errors.cumulative.y(), 0.55, 1e-12);
}

TEST(AxisErrors, ATurnAboutZIsSeenInTheAngleAboutZ) {
  const AxisErrors errors = axis_errors(drifting(5));
  EXPECT_NEAR(errors.euler_deg[2].min, 0.02 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(errors.euler_deg[0].max, 0, 1e-9);
  EXPECT_NEAR(errors.euler_deg[1].max, 0, 1e-9);
}

TEST(AxisErrors, AnglesOnBothSidesOfAHalfTurnAreClose) {
  TrajectoryPair pair;
  pair.reference.add(0, {so3_exp({0, 0, M_PI - 0.01}), Eigen::Vector3d::Zero()});
  pair.estimate.add(0, {so3_exp({0, 0, -M_PI + 0.01}), Eigen::Vector3d::Zero()});
  EXPECT_NEAR(axis_errors(pair).euler_deg[2].max, 0.02 * 180 / M_PI, 1e-9);
}

TEST(AxisErrors, TheLastRowOfTheCumulativeDeviationIsItsSum) {
  const TrajectoryPair pair = drifting(20);
  const auto sums = cumulative_deviation(pair);
  ASSERT_EQ(sums.rows(), 20);
  EXPECT_LT((sums.row(19).transpose() - axis_errors(pair).cumulative).norm(), 1e-12);
  for (int i = 1; i < 20; ++i) EXPECT_GE(sums(i, 1), sums(i - 1, 1));
}

TEST(AxisErrors, NoPosesAreRefused) { EXPECT_THROW(axis_errors({}), std::invalid_argument); }

}  // namespace
}  // namespace framewise
