// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/frame_rate.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

std::vector<double> even_times(int count, double step, double begin = 0) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(begin + i * step);
  return times;
}

TEST(FrameRate, OfAnEvenRecordingHasNoJitterAndNoGaps) {
  const FrameRate rate = frame_rate(even_times(100, 1.0 / 30));
  EXPECT_NEAR(rate.median_step, 1.0 / 30, 1e-12);
  EXPECT_LT(rate.jitter, 1e-12);
  EXPECT_TRUE(rate.gaps.empty());
  EXPECT_TRUE(rate.is_plausible());
  EXPECT_EQ(rate.pause(), nullptr);
}

TEST(FrameRate, NamesTheGaps) {
  auto times = even_times(10, 0.1);
  times.erase(times.begin() + 4, times.begin() + 6);  // 0.3 -> 0.6
  const FrameRate rate = frame_rate(times);
  ASSERT_EQ(rate.gaps.size(), 1u);
  EXPECT_NEAR(rate.gaps[0].after, 0.3, 1e-12);
  EXPECT_NEAR(rate.gaps[0].length, 0.3, 1e-12);
  EXPECT_NEAR(rate.longest_step, 0.3, 1e-12);
  EXPECT_EQ(rate.pause(), nullptr);
}

TEST(FrameRate, JitterIsTheMedianDeviation) {
  EXPECT_NEAR(frame_rate(std::vector<double>{0, 1, 2.1, 3, 4.1, 5.1}).jitter, 0.1, 0.051);
}

TEST(FrameRate, TellsAPauseBetweenTwoRuns) {
  auto times = even_times(50, 0.05);
  const auto second = even_times(50, 0.05, 100);
  times.insert(times.end(), second.begin(), second.end());
  const FrameRate rate = frame_rate(times);
  ASSERT_NE(rate.pause(), nullptr);
  EXPECT_NEAR(rate.pause()->after, 49 * 0.05, 1e-9);
}

TEST(FrameRate, StampsThatAreNoSecondsAreImplausible) {
  EXPECT_FALSE(frame_rate(even_times(10, 33.3)).is_plausible());   // milliseconds
  EXPECT_FALSE(frame_rate(even_times(10, 33e-6)).is_plausible());  // thousands of seconds
  EXPECT_TRUE(frame_rate(even_times(10, 1)).is_plausible());
}

TEST(FrameRate, OfOneFrameIsNone) {
  EXPECT_EQ(frame_rate({}).median_step, 0);
  EXPECT_EQ(frame_rate(std::vector<double>{3}).median_step, 0);
  EXPECT_TRUE(frame_rate(std::vector<double>{3}).is_plausible());
}

}  // namespace
}  // namespace framewise
