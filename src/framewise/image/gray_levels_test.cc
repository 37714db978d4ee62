// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/gray_levels.h"

#include <gtest/gtest.h>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

TEST(GrayLevels, RoundToTheNearestAndMarkTheUnknownWithZero) {
  const cv::Mat unit = (cv::Mat_<float>(1, 6) << 0, 1, 0.5f, kNoDepth, 1.5f, -0.5f);
  EXPECT_TRUE(same_bytes(to_16_bit(unit), (cv::Mat_<std::uint16_t>(1, 6) << 0, 65535, 32768, 0, 65535, 0)));
  EXPECT_TRUE(same_bytes(to_8_bit(unit), (cv::Mat_<std::uint8_t>(1, 6) << 0, 255, 128, 0, 255, 0)));
}

TEST(DepthToUnit, IsLinearFromNearToFarAndAboveTheUnknown) {
  const cv::Mat depth = (cv::Mat_<float>(1, 6) << 0.5f, 1, 2, 3, 9, kNoDepth);
  const cv::Mat gray = to_8_bit(depth_to_unit(depth, {1, 3}));
  EXPECT_TRUE(same_bytes(gray, (cv::Mat_<std::uint8_t>(1, 6) << 1, 1, 128, 255, 255, 0)));
  EXPECT_EQ(to_8_bit(depth_to_unit(depth, {})).at<std::uint8_t>(0, 4), 255);  // the farthest
  EXPECT_THROW(depth_to_unit(depth, {3, 2}), std::invalid_argument);
  EXPECT_EQ(count_unknown(depth_to_unit(cv::Mat(2, 2, CV_32F, cv::Scalar(0)), {})), 4);
}

TEST(Clahe, SpreadsTheLevelsOfAFlatImageAndLeavesTheUnknownBlack) {
  cv::Mat unit(64, 64, CV_32F);
  for (int v = 0; v < 64; ++v)
    for (int u = 0; u < 64; ++u)
      unit.at<float>(v, u) = 0.5f + 0.0005f * static_cast<float>((u * 7 + v * 3) % 64);
  unit.at<float>(30, 30) = kNoDepth;
  const cv::Mat plain = to_8_bit(unit), spread = equalise_to_8_bit(unit, {40, 4});
  cv::Scalar mean, plain_deviation, deviation;
  cv::meanStdDev(plain, mean, plain_deviation);
  cv::meanStdDev(spread, mean, deviation);
  EXPECT_GT(deviation[0], 5 * plain_deviation[0]);
  EXPECT_EQ(spread.at<std::uint8_t>(30, 30), 0);
  EXPECT_EQ(spread.type(), CV_8U);
}

TEST(GrayLevels, TakeASinglePixelAndRefuseOtherTypes) {
  EXPECT_EQ(equalise_to_8_bit(cv::Mat(1, 1, CV_32F, cv::Scalar(0.5)), {}).size(), cv::Size(1, 1));
  EXPECT_THROW(to_16_bit({}), std::invalid_argument);
  EXPECT_THROW(to_8_bit(cv::Mat(2, 2, CV_16U)), std::invalid_argument);
  EXPECT_THROW(equalise_to_8_bit(cv::Mat(2, 2, CV_32F), {0, 8}), std::invalid_argument);
  EXPECT_THROW(equalise_to_8_bit(cv::Mat(2, 2, CV_32F), {4, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
