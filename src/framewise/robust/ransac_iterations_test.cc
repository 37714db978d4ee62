// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/ransac_iterations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace framewise {
namespace {

TEST(RansacIterations, FollowFromTheProbabilityOfACleanSample) {
  // The table of Fischler and Bolles' formula in Hartley and Zisserman, p. 119, before rounding up.
  EXPECT_EQ(std::ceil(ransac_iterations(0.99, 0.5, 5)), 146);
  EXPECT_EQ(std::ceil(ransac_iterations(0.99, 0.5, 8)), 1177);
  EXPECT_EQ(std::ceil(ransac_iterations(0.99, 0.9, 3)), 4);
  for (const double share : {0.1, 0.3, 0.8}) {
    const double n = ransac_iterations(0.95, share, 5);
    EXPECT_NEAR(1 - std::pow(1 - std::pow(share, 5), n), 0.95, 1e-9) << share;
  }
}

TEST(RansacIterations, AreOneWithoutOutliersAndInfiniteWithoutInliers) {
  EXPECT_EQ(ransac_iterations(0.99, 1, 5), 1);
  EXPECT_EQ(ransac_iterations(0.99, 0, 5), std::numeric_limits<double>::infinity());
}

TEST(RansacIterations, RefuseWhatIsNoProbability) {
  EXPECT_THROW(ransac_iterations(1, 0.5, 5), std::invalid_argument);
  EXPECT_THROW(ransac_iterations(0.99, 1.5, 5), std::invalid_argument);
  EXPECT_THROW(ransac_iterations(0.99, std::nan(""), 5), std::invalid_argument);
  EXPECT_THROW(ransac_iterations(0.99, 0.5, 0), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
