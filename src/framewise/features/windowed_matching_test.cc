// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/windowed_matching.h"

#include <gtest/gtest.h>

#include "framewise/features/descriptors_for_tests.h"

namespace framewise {
namespace {

using Kind = DescriptorKind;

std::vector<cv::Point2f> random_pixels(int count, float width, float height, std::uint64_t seed) {
  std::vector<cv::Point2f> pixels;
  cv::RNG rng(seed);
  for (int i = 0; i < count; ++i) pixels.push_back({rng.uniform(0.f, width), rng.uniform(0.f, height)});
  return pixels;
}

struct WindowedProblem {
  cv::Mat d1, d2;
  std::vector<cv::Point2f> predicted2, pixels2;
  cv::Mat_<float> distances;

  auto match(const MatchOptions& options) const {
    return match_windowed(d1, predicted2, d2, pixels2, options);
  }
  auto plain(const MatchOptions& options) const {
    return plain_matches(distances, options, [&](int i, int j) {
      const double dx = pixels2[j].x - static_cast<double>(predicted2[i].x);
      const double dy = pixels2[j].y - static_cast<double>(predicted2[i].y);
      return dx * dx + dy * dy <= options.window_px * options.window_px;  // false for NaN
    });
  }
};

WindowedProblem windowed_problem(Kind kind, int columns, int rows1, int rows2) {
  const cv::Mat d1 = random_descriptors(kind, rows1, columns, 1);
  const cv::Mat d2 = noisy_copies(d1, rows2, 2);
  return {d1, d2, random_pixels(rows1, 640, 480, 3), random_pixels(rows2, 640, 480, 4),
          plain_distances(d1, d2)};
}

TEST(MatchWindowed, IsExactMatchingOfThosePairsThatAreNear) {
  for (const auto& [kind, columns] : {std::pair{Kind::kBits, 32}, {Kind::kBits, 61}, {Kind::kFloats, 64}}) {
    const WindowedProblem p = windowed_problem(kind, columns, 300, 400);
    for (const double window_px : {0.5, 15.0, 40.0, 200.0, 1000.0})
      for (const bool cross_check : {false, true})
        for (const double max_ratio : {1.0, 0.8}) {
          MatchOptions options;
          options.window_px = window_px;
          options.cross_check = cross_check;
          options.max_ratio = max_ratio;
          EXPECT_TRUE(p.match(options) == p.plain(options)) << window_px;
        }
  }
}

TEST(MatchWindowed, AWindowAroundEverythingIsMatchingWithoutOne) {
  const WindowedProblem p = windowed_problem(Kind::kBits, 32, 200, 300);
  MatchOptions options;
  options.window_px = 2000;
  EXPECT_TRUE(p.match(options) == match_features(p.d1, p.d2, options));
}

TEST(MatchWindowed, WhatIsNowhereHasNoMatch) {
  WindowedProblem p = windowed_problem(Kind::kBits, 32, 100, 100);
  const float nowhere[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f};
  for (int k = 0; k < 5; ++k) p.predicted2[7 * k] = {nowhere[k], 100}, p.pixels2[9 * k] = {100, nowhere[k]};
  MatchOptions options;
  options.window_px = 100;
  const auto matches = p.match(options);
  EXPECT_TRUE(matches == p.plain(options));
  EXPECT_FALSE(matches.empty());
  for (const FeatureMatch& m : matches) EXPECT_TRUE(m.index1 % 7 || m.index1 >= 35) << m.index1;
  std::fill(p.pixels2.begin(), p.pixels2.end(), cv::Point2f(NAN, NAN));
  EXPECT_TRUE(p.match(options).empty());
}

TEST(MatchWindowed, PointsOnOneSpotAreNear) {
  WindowedProblem p = windowed_problem(Kind::kBits, 32, 50, 60);
  std::fill(p.pixels2.begin(), p.pixels2.end(), cv::Point2f(5, 5));
  std::fill(p.predicted2.begin(), p.predicted2.end(), cv::Point2f(5, 6));
  MatchOptions options;
  options.window_px = 1;
  EXPECT_TRUE(p.match(options) == match_features(p.d1, p.d2));
  options.window_px = 0.999;
  EXPECT_TRUE(p.match(options).empty());
}

TEST(MatchWindowed, GivesNothingForNothingAndRefusesOtherSizes) {
  const WindowedProblem p = windowed_problem(Kind::kBits, 32, 10, 12);
  EXPECT_TRUE(match_windowed(cv::Mat(), {}, p.d2, p.pixels2).empty());
  EXPECT_TRUE(match_windowed(p.d1, p.predicted2, cv::Mat(), {}).empty());
  EXPECT_THROW(match_windowed(p.d1, p.pixels2, p.d2, p.pixels2), std::invalid_argument);
  EXPECT_THROW(match_windowed(p.d1, p.predicted2, p.d2, p.predicted2), std::invalid_argument);
  MatchOptions options;
  options.window_px = 0;
  EXPECT_THROW(p.match(options), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
