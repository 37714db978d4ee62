// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/patch_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace framewise {
namespace {

// A texture of waves of many directions, moved by (dx, dy).
cv::Mat waves(double dx, double dy) {
  cv::Mat image(120, 160, CV_8U);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      double sum = 128;
      for (int k = 0; k < 8; ++k)
        sum += 14 * std::sin((0.3 + 0.05 * k) * (std::cos(k) * (x - dx) + std::sin(k) * (y - dy)) + k * k);
      image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(sum);
    }
  }
  return image;
}

TEST(PatchAlignment, FindsShiftsToFractionsOfAPixel) {
  const cv::Mat still = waves(0, 0), moved = waves(0.37, -0.61);
  std::vector<cv::Point2f> pixels1, pixels2;
  for (float y = 20; y < 100; y += 10)
    for (float x = 20; x < 140; x += 10) pixels1.push_back({x, y}), pixels2.push_back({x, y - 1});
  align_patches(still, moved, pixels1, pixels2);
  for (std::size_t i = 0; i < pixels1.size(); ++i)
    EXPECT_LT(cv::norm(pixels2[i] - pixels1[i] - cv::Point2f(0.37f, -0.61f)), 0.1) << i;
}

TEST(PatchAlignment, LeavesWhatItCannotSee) {
  const cv::Mat black(60, 80, CV_8U, cv::Scalar(0));
  const std::vector<cv::Point2f> pixels1{{20, 20}, {-5, 300}, {79, 59}};
  std::vector<cv::Point2f> pixels2{{21, 20}, {400, -7}, {79, 59}};
  const auto before = pixels2;
  align_patches(black, black, pixels1, pixels2);
  EXPECT_EQ(pixels2, before);
  const cv::Mat dot(1, 1, CV_8U, cv::Scalar(9));
  align_patches(dot, dot, pixels1, pixels2);
  EXPECT_EQ(pixels2, before);
  std::vector<cv::Point2f> none;
  align_patches(black, black, {}, none);
  EXPECT_TRUE(none.empty());
}

TEST(PatchAlignment, DoesNotFollowAnotherCorner) {
  const cv::Mat still = waves(0, 0), moved = waves(4, 0);
  const std::vector<cv::Point2f> pixels1{{60, 60}};
  std::vector<cv::Point2f> pixels2{{60.5f, 60}};
  PatchAlignmentOptions options;
  options.max_shift = 1;
  align_patches(still, moved, pixels1, pixels2, options);
  EXPECT_LE(cv::norm(pixels2[0] - cv::Point2f(60.5f, 60)), 1);
}

}  // namespace
}  // namespace framewise
