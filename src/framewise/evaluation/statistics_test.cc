// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace framewise {
namespace {

TEST(Statistics, HaveTheirDefinitions) {
  const std::array errors = {4.0, 1.0, 3.0, 2.0};
  const Statistics s = statistics(errors);
  EXPECT_EQ(s.count, 4u);
  EXPECT_DOUBLE_EQ(s.sse, 30);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(7.5));
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.median, 2.5);           // between the middle two
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(1.25));  // of the population; of a sample it would be sqrt(5 / 3)
  EXPECT_DOUBLE_EQ(s.min, 1);
  EXPECT_DOUBLE_EQ(s.max, 4);
}

TEST(Statistics, MedianOfAnOddCountIsTheMiddle) {
  EXPECT_EQ(median(std::array{9.0, -1.0, 2.0}), 2);
  EXPECT_EQ(median(std::array{7.0}), 7);
}

TEST(Statistics, RefuseNothingAndWhatIsNoNumber) {
  EXPECT_THROW(statistics({}), std::invalid_argument);
  EXPECT_THROW(median({}), std::invalid_argument);
  EXPECT_THROW(statistics(std::array{1.0, std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  EXPECT_THROW(statistics(std::array{1.0, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
