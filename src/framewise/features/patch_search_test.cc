// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/patch_search.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/imgproc.hpp>

namespace framewise {
namespace {

// Nothing in it is twice.
cv::Mat noise_image() {
  cv::Mat coarse(120, 160, CV_8U), gray;
  cv::RNG rng(5);
  rng.fill(coarse, cv::RNG::UNIFORM, 0, 256);
  cv::resize(coarse, gray, {}, 2, 2, cv::INTER_CUBIC);
  return gray;
}

cv::Mat shifted(const cv::Mat& gray, double du, double dv) {
  cv::Mat moved;
  cv::warpAffine(gray, moved, cv::Matx23d(1, 0, du, 0, 1, dv), gray.size(), cv::INTER_LINEAR);
  return moved;
}

PatchWarp from(const Eigen::Vector2d& pixel1, const Eigen::Vector2d& pixel2) {
  return {pixel1, pixel2, Eigen::Matrix2d::Identity(), 0};
}

const Eigen::Vector2d kPixel(120, 110);

TEST(SearchPatch, FindsAPatchFarAlongItsSegmentToAboutAPixel) {
  const cv::Mat gray = noise_image();
  const auto levels1 = image_levels(gray), levels2 = image_levels(shifted(gray, 60, 30));
  const auto found = search_patch(levels1, levels2, from(kPixel, kPixel), kPixel + Eigen::Vector2d(100, 50));
  ASSERT_TRUE(found);
  EXPECT_LT((*found - kPixel - Eigen::Vector2d(60, 30)).norm(), 1.0);
}

TEST(SearchPatch, DoesNotFindWhatIsNotOnTheSegment) {
  const cv::Mat gray = noise_image();
  const auto levels1 = image_levels(gray), levels2 = image_levels(shifted(gray, 60, 30));
  EXPECT_FALSE(search_patch(levels1, levels2, from(kPixel, kPixel), kPixel + Eigen::Vector2d(100, -50)));
}

TEST(SearchPatch, WhatIsThereTwiceIsNotFound) {
  cv::Mat gray = noise_image(), twice = gray.clone();
  gray(cv::Rect(105, 95, 31, 31)).copyTo(twice(cv::Rect(165, 95, 31, 31)));
  EXPECT_TRUE(search_patch(image_levels(gray), image_levels(gray),
                           from(kPixel, kPixel - Eigen::Vector2d(20, 0)), kPixel + Eigen::Vector2d(80, 0)));
  EXPECT_FALSE(search_patch(image_levels(gray), image_levels(twice),
                            from(kPixel, kPixel - Eigen::Vector2d(20, 0)), kPixel + Eigen::Vector2d(80, 0)));
}

TEST(SearchPatch, NothingToSeeAndNowhereToLookAreNoCrash) {
  const auto flat = image_levels(cv::Mat(240, 320, CV_8U, cv::Scalar(90))),
             levels = image_levels(noise_image());
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(search_patch(flat, flat, from(kPixel, kPixel), kPixel + Eigen::Vector2d(50, 0)));
  EXPECT_FALSE(search_patch(levels, flat, from(kPixel, kPixel), kPixel + Eigen::Vector2d(50, 0)));
  EXPECT_FALSE(search_patch(levels, levels, from(kPixel, kPixel), nowhere));
  EXPECT_FALSE(search_patch(levels, levels, from(kPixel, {-1e9, 3}), Eigen::Vector2d(-1e9, 9)));
  EXPECT_FALSE(search_patch({}, levels, from(kPixel, kPixel), kPixel));
}

}  // namespace
}  // namespace framewise
