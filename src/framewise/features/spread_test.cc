// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace framewise {
namespace {

const cv::Size kImage(640, 480);

// Nine of ten in the upper left sixteenth of the image, strongest first.
std::vector<cv::KeyPoint> crowded(int count, std::uint64_t seed) {
  cv::RNG rng(seed);
  std::vector<cv::KeyPoint> keypoints;
  for (int i = 0; i < count; ++i) {
    const float share = i % 10 == 9 ? 1.0f : 0.25f;
    keypoints.emplace_back(rng.uniform(0.0f, 640 * share), rng.uniform(0.0f, 480 * share), 10.0f, -1.0f,
                           static_cast<float>(count - i));
  }
  return keypoints;
}

int in_the_crowd(const std::vector<cv::KeyPoint>& keypoints, const std::vector<int>& kept) {
  return static_cast<int>(std::count_if(
      kept.begin(), kept.end(), [&](int i) { return keypoints[i].pt.x < 160 && keypoints[i].pt.y < 120; }));
}

TEST(Spread, KeepsWhatIsAskedForEachOnceInOrder) {
  const auto keypoints = crowded(2000, 1);
  for (const Spread spread : {Spread::kNone, Spread::kGrid, Spread::kAnms})
    for (const int count : {8, 100, 500, 1999, 2000, 5000}) {
      const auto kept = spread_out(keypoints, kImage, count, spread);
      EXPECT_EQ(kept.size(), static_cast<std::size_t>(std::min(count, 2000)));
      EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
      EXPECT_EQ(std::set<int>(kept.begin(), kept.end()).size(), kept.size());
      EXPECT_LT(*std::max_element(kept.begin(), kept.end()), 2000);
    }
}

TEST(Spread, ThinsTheCrowd) {
  const auto keypoints = crowded(2000, 2);
  const int strongest = in_the_crowd(keypoints, spread_out(keypoints, kImage, 200, Spread::kNone));
  EXPECT_GT(strongest, 170);
  for (const Spread spread : {Spread::kGrid, Spread::kAnms}) {
    const auto kept = spread_out(keypoints, kImage, 200, spread);
    EXPECT_LT(in_the_crowd(keypoints, kept), 80);
    EXPECT_EQ(kept.front(), 0) << "the strongest stays";
  }
}

TEST(Spread, OfAnmsIsWiderThanOfTheStrongest) {
  const auto keypoints = crowded(3000, 3);
  const auto nearest = [&](const std::vector<int>& kept) {
    double sum = 0;
    for (const int i : kept) {
      double best = 1e9;
      for (const int j : kept)
        if (i != j) best = std::min(best, cv::norm(keypoints[i].pt - keypoints[j].pt));
      sum += best;
    }
    return sum / static_cast<double>(kept.size());
  };
  EXPECT_GT(nearest(spread_out(keypoints, kImage, 300, Spread::kAnms)),
            1.7 * nearest(spread_out(keypoints, kImage, 300, Spread::kNone)));
}

TEST(Spread, BearsManyAtOnePlaceAndNone) {
  const std::vector<cv::KeyPoint> same(50, cv::KeyPoint(3, 3, 10));
  for (const Spread spread : {Spread::kGrid, Spread::kAnms}) {
    EXPECT_EQ(spread_out(same, kImage, 20, spread).size(), 20u);
    EXPECT_TRUE(spread_out({}, kImage, 20, spread).empty());
    EXPECT_EQ(spread_out(same, {1, 1}, 20, spread).size(), 20u);
  }
}

}  // namespace
}  // namespace framewise
