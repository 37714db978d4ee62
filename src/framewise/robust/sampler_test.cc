// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace framewise {
namespace {

TEST(RandomStream, IsTheSameOnEveryPlatform) {
  RandomStream random(0);
  EXPECT_EQ(random.next(), 0xe220a8397b1dcdafu);  // SplitMix64's first value for seed 0
}

TEST(DrawDistinct, NeverRepeatsAndReachesEveryIndex) {
  RandomStream random(1);
  std::array<int, 9> count{};
  for (int trial = 0; trial < 9000; ++trial) {
    std::array<std::uint32_t, 4> sample{};
    draw_distinct(9, sample, random);
    EXPECT_EQ(std::set<std::uint32_t>(sample.begin(), sample.end()).size(), 4u);
    for (const auto i : sample) ++count[i];
  }
  for (const int n : count) EXPECT_NEAR(n, 4000, 300);
}

TEST(Prosac, BeginsWithTheBestAndEndsWithAll) {
  RandomStream random(2);
  ProsacSampler sampler(200, 5, 1000);
  std::array<std::uint32_t, 5> sample{};
  std::uint32_t widest_early = 0, widest_late = 0;
  for (int t = 0; t < 5000; ++t) {
    sampler.draw(sample, random);
    EXPECT_EQ(std::set<std::uint32_t>(sample.begin(), sample.end()).size(), 5u);
    const std::uint32_t widest = *std::max_element(sample.begin(), sample.end());
    EXPECT_LT(widest, 200u);
    if (t < 10) widest_early = std::max(widest_early, widest);
    if (t >= 4000) widest_late = std::max(widest_late, widest);
  }
  EXPECT_LT(widest_early, 40u);
  EXPECT_EQ(widest_late, 199u);
}

}  // namespace
}  // namespace framewise
