// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/spread.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "framewise/evaluation/statistics.h"

namespace framewise {
namespace {

TEST(Quantile, LiesBetweenTheSortedValues) {
  const std::vector<double> values{4, 1, 3, 2};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 1), 4);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);  // numpy.quantile([4, 1, 3, 2], 0.25)
  EXPECT_DOUBLE_EQ(quantile(values, 0.9), 3.7);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), median(values));
}

TEST(Quantile, OfOneValueIsThatValue) {
  const std::vector<double> values{7};
  for (const double p : {0.0, 0.3, 1.0}) EXPECT_EQ(quantile(values, p), 7);
}

TEST(Quantile, RefusesNothingAndSharesOutsideZeroToOne) {
  const std::vector<double> values{1, 2};
  EXPECT_THROW(quantile({}, 0.5), std::invalid_argument);
  for (const double p : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(quantile(values, p), std::invalid_argument);
}

TEST(SpreadOverRepeats, IsMedianAndQuartiles) {
  const std::vector<double> values{5, 1, 2, 4, 3};
  const Spread s = spread(values);
  EXPECT_EQ(s.median, 3);
  EXPECT_EQ(s.first_quartile, 2);
  EXPECT_EQ(s.third_quartile, 4);
  EXPECT_EQ(s.count, 5u);
  EXPECT_THROW(spread({}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
