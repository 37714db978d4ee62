// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching.h"

#include <gtest/gtest.h>

#include <opencv2/features2d.hpp>

namespace framewise {
namespace {

cv::Mat random_descriptors(int rows, std::uint64_t seed) {
  cv::Mat descriptors(rows, 32, CV_8U);
  cv::RNG rng(seed);
  rng.fill(descriptors, cv::RNG::UNIFORM, 0, 256);
  return descriptors;
}

TEST(MatchBruteForce, FindsWhatExhaustiveSearchFinds) {
  const cv::Mat d1 = random_descriptors(150, 1), d2 = random_descriptors(170, 2);
  std::vector<cv::DMatch> expected;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(d1, d2, expected);
  const auto matches = match_brute_force(d1, d2);
  ASSERT_EQ(matches.size(), expected.size());
  for (std::size_t i = 0; i < matches.size(); ++i) {
    EXPECT_EQ(matches[i].index1, expected[i].queryIdx);
    EXPECT_EQ(matches[i].index2, expected[i].trainIdx);
    EXPECT_EQ(matches[i].distance, static_cast<int>(expected[i].distance));
  }
}

TEST(MatchBruteForce, MatchesAShuffledCopyExactly) {
  const cv::Mat d1 = random_descriptors(64, 3);
  cv::Mat d2;
  cv::flip(d1, d2, 0);
  const auto matches = match_brute_force(d1, d2);
  ASSERT_EQ(matches.size(), 64u);
  for (const FeatureMatch& m : matches) {
    EXPECT_EQ(m.index2, 63 - m.index1);
    EXPECT_EQ(m.distance, 0);
  }
}

TEST(MatchBruteForce, GivesNothingForNothing) {
  EXPECT_TRUE(match_brute_force(cv::Mat(), random_descriptors(5, 1)).empty());
  EXPECT_TRUE(match_brute_force(random_descriptors(5, 1), cv::Mat()).empty());
}

TEST(MatchBruteForce, RefusesDescriptorsOfDifferentLength) {
  EXPECT_THROW(match_brute_force(random_descriptors(5, 1), random_descriptors(5, 1).colRange(0, 16)),
               std::invalid_argument);
}

}  // namespace
}  // namespace framewise
