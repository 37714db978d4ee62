// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/hole_filling.h"

#include <gtest/gtest.h>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

constexpr FillMethod kBoth[] = {FillMethod::kNearest, FillMethod::kSmooth};

FillOptions options_of(FillMethod method, double max_reach_px = 0) { return {method, max_reach_px}; }

TEST(FillHoles, LeavesKnownPixelsAsTheyAreAndKnowsAllOthers) {
  for (const FillMethod method : kBoth)
    for (const cv::Size size : {cv::Size(64, 48), cv::Size(61, 37), cv::Size(1, 9), cv::Size(2, 1)}) {
      cv::Mat depth = random_depth(size.width, size.height, 1);
      std::mt19937 random(2);
      for (int v = 0; v < size.height; ++v)
        for (int u = 0; u < size.width; ++u)
          if (u + v > 0 && random() % 2) depth.at<float>(v, u) = random() % 2 ? kNoDepth : 0;
      const cv::Mat filled = fill_holes(depth, options_of(method));
      for (int v = 0; v < size.height; ++v)
        for (int u = 0; u < size.width; ++u) {
          const float before = depth.at<float>(v, u), after = filled.at<float>(v, u);
          if (before > 0) {
            EXPECT_EQ(before, after);
          }
          EXPECT_GT(after, 0);
        }
    }
}

TEST(FillHoles, NearestTakesTheDepthOfTheNearestPixel) {
  cv::Mat depth(1, 9, CV_32F, cv::Scalar(kNoDepth));
  depth.at<float>(0, 0) = 1;
  depth.at<float>(0, 8) = 2;
  const cv::Mat filled = fill_holes(depth, options_of(FillMethod::kNearest));
  for (int u = 0; u < 9; ++u)
    if (u != 4) {
      EXPECT_EQ(filled.at<float>(0, u), u < 4 ? 1 : 2);
    }
}

TEST(FillHoles, SmoothLeavesNoSeamInAPlane) {
  const DepthRays rays(pinhole_camera(128, 96), DepthType::kZ);
  const cv::Mat plane = plane_depth(rays, {0.2, 0.1, 1}, 2);
  cv::Mat depth = plane.clone();
  depth(cv::Rect(40, 30, 20, 15)) = kNoDepth;
  EXPECT_LT(largest_difference(fill_holes(depth, options_of(FillMethod::kSmooth)), plane), 0.1);
  const cv::Mat constant(40, 50, CV_32F, cv::Scalar(2));
  cv::Mat holed = constant.clone();
  holed(cv::Rect(3, 3, 30, 30)) = kNoDepth;
  EXPECT_LT(largest_difference(fill_holes(holed, options_of(FillMethod::kSmooth)), constant), 1e-6);
}

TEST(FillHoles, GoesNoFartherThanItsReach) {
  for (const FillMethod method : kBoth) {
    cv::Mat depth(21, 21, CV_32F, cv::Scalar(kNoDepth));
    depth.at<float>(10, 10) = 2;
    const cv::Mat filled = fill_holes(depth, options_of(method, 5));
    for (int v = 0; v < 21; ++v)
      for (int u = 0; u < 21; ++u)
        EXPECT_EQ(std::isnan(filled.at<float>(v, u)), std::hypot(u - 10, v - 10) > 5.001) << u << " " << v;
  }
}

TEST(FillHoles, OfNothingIsNothing) {
  for (const FillMethod method : kBoth) {
    EXPECT_EQ(count_unknown(fill_holes(cv::Mat(5, 7, CV_32F, cv::Scalar(kNoDepth)), options_of(method))), 35);
    EXPECT_EQ(count_unknown(fill_holes(cv::Mat(1, 1, CV_32F, cv::Scalar(0)), options_of(method))), 1);
    EXPECT_THROW(fill_holes({}, options_of(method)), std::invalid_argument);
    EXPECT_THROW(fill_holes(cv::Mat(5, 7, CV_16U), options_of(method)), std::invalid_argument);
    EXPECT_THROW(fill_holes(cv::Mat(5, 7, CV_32F), options_of(method, -1)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace framewise
