// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/tracking_corners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace framewise {
namespace {

// Black and white squares of 16 pixels: corners where four meet.
cv::Mat chessboard() {
  cv::Mat gray(120, 160, CV_8U);
  for (int y = 0; y < gray.rows; ++y)
    for (int x = 0; x < gray.cols; ++x) gray.at<std::uint8_t>(y, x) = (x / 16 + y / 16) % 2 ? 220 : 30;
  return gray;
}

TEST(DetectCorners, AreWhereSquaresMeet) {
  const auto corners = detect_corners(chessboard());
  EXPECT_EQ(corners.size(), 9u * 7u);
  for (const cv::Point2f& p : corners) {
    EXPECT_LE(std::abs(p.x - (16 * std::round(p.x / 16) - 0.5)), 1.5) << p;
    EXPECT_LE(std::abs(p.y - (16 * std::round(p.y / 16) - 0.5)), 1.5) << p;
  }
}

TEST(DetectCorners, KeepTheirDistanceAndTheirNumber) {
  cv::Mat noise(120, 160, CV_8U);
  cv::RNG rng(1);
  rng.fill(noise, cv::RNG::UNIFORM, 0, 256);
  CornerOptions options;
  options.count = 40;
  options.min_distance_px = 12;
  const auto corners = detect_corners(noise, options);
  EXPECT_EQ(corners.size(), 40u);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE(cv::norm(corners[i] - corners[j]), 12);
}

TEST(DetectCorners, LeaveRoomAroundWhatIsTaken) {
  const cv::Mat gray = chessboard();
  std::vector<cv::Point2f> taken(detect_corners(gray));
  taken.resize(20);
  taken.insert(taken.end(), {{NAN, 5}, {1e30f, -1e30f}, {-INFINITY, 0}});
  const auto corners = detect_corners(gray, {}, taken);
  EXPECT_EQ(corners.size(), 63u - 20u);
  for (const cv::Point2f& p : corners)
    for (int i = 0; i < 20; ++i) EXPECT_GT(cv::norm(p - taken[i]), 6);
}

TEST(DetectCorners, AnEvenImageHasNone) {
  EXPECT_TRUE(detect_corners(cv::Mat(120, 160, CV_8U, cv::Scalar(0))).empty());
  EXPECT_TRUE(detect_corners(cv::Mat(1, 1, CV_8U, cv::Scalar(9))).empty());
  EXPECT_TRUE(detect_corners(cv::Mat(2, 300, CV_8U, cv::Scalar(9))).empty());
}

TEST(DetectCorners, RefusesOtherImagesAndOptions) {
  using ::testing::HasSubstr;
  using ::testing::ThrowsMessage;
  EXPECT_THAT([] { detect_corners(cv::Mat()); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("gray: found no pixels")));
  EXPECT_THAT([] { detect_corners(cv::Mat(9, 9, CV_8UC3, cv::Scalar())); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("found CV_8UC3")));
  CornerOptions options;
  options.count = 0;
  EXPECT_THAT([&] { options.check(); }, ThrowsMessage<std::invalid_argument>(HasSubstr("count: found 0")));
  options = {};
  options.quality = NAN;
  EXPECT_THROW(options.check(), std::invalid_argument);
  options = {};
  options.min_distance_px = -1;
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
