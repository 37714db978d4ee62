// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_frame.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

TEST(Describe, TakesWhatWasFoundAheadAsIfItHadLookedItself) {
  const Boxes boxes;
  MapFrame at_once = look_at(boxes.frame({}, 0), 0), ahead = at_once;
  describe(at_once, Boxes::camera(), {});
  find_features(ahead, {});
  EXPECT_FALSE(ahead.is_described);
  EXPECT_TRUE(ahead.rays.empty());
  describe(ahead, Boxes::camera(), {});
  EXPECT_FALSE(ahead.found);
  ASSERT_GT(at_once.rays.size(), 100u);
  EXPECT_EQ(ahead.rays, at_once.rays);
  ASSERT_EQ(ahead.features.descriptors.size(), at_once.features.descriptors.size());
  EXPECT_EQ(cv::norm(ahead.features.descriptors, at_once.features.descriptors, cv::NORM_HAMMING), 0);
  for (std::size_t i = 0; i < at_once.rays.size(); ++i)
    EXPECT_EQ(ahead.features.keypoints[i].pt, at_once.features.keypoints[i].pt);
}

TEST(Describe, FindsNothingWhereThereIsNoImage) {
  MapFrame dark;
  find_features(dark, {});
  describe(dark, Boxes::camera(), {});
  EXPECT_TRUE(dark.is_described);
  EXPECT_TRUE(dark.rays.empty());
}

}  // namespace
}  // namespace framewise
