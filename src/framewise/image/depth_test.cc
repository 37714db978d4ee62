// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/depth.h"

#include <gtest/gtest.h>

#include <limits>

namespace framewise {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

cv::Mat flat_depth() { return cv::Mat(20, 30, CV_32F, cv::Scalar(2.0)); }

TEST(DepthFromRaw, DividesByTheFactorAndMarksZeroAndTooFarAsUnknown) {
  const cv::Mat raw = (cv::Mat_<std::uint16_t>(1, 4) << 0, 5000, 12345, 60000);
  const cv::Mat depth = depth_from_raw(raw, 5000, 10.0);
  EXPECT_TRUE(std::isnan(depth.at<float>(0, 0)));
  EXPECT_FLOAT_EQ(depth.at<float>(0, 1), 1.0f);
  EXPECT_FLOAT_EQ(depth.at<float>(0, 2), 2.469f);
  EXPECT_TRUE(std::isnan(depth.at<float>(0, 3)));
}

TEST(DepthFromRaw, TakesFloatsForMetres) {
  const float infinite = std::numeric_limits<float>::infinity();
  const cv::Mat raw = (cv::Mat_<float>(1, 6) << 1.5f, 0, -1, kUnknown, infinite, 12);
  const cv::Mat depth = depth_from_raw(raw, 5000, 10.0);
  EXPECT_EQ(depth.at<float>(0, 0), 1.5f);
  for (int u = 1; u < 6; ++u) EXPECT_TRUE(std::isnan(depth.at<float>(0, u))) << u;
  EXPECT_THROW(depth_from_raw(cv::Mat(2, 2, CV_8U), 5000, 10), std::invalid_argument);
}

TEST(DepthAt, GivesTheDepthOfASmoothSurface) {
  EXPECT_DOUBLE_EQ(depth_at(flat_depth(), {10.3, 9.6}, {}).value(), 2.0);
}

TEST(DepthAt, RejectsUnknownPixels) {
  for (const float bad : {kUnknown, 0.0f, -1.0f, std::numeric_limits<float>::infinity()}) {
    cv::Mat depth = flat_depth();
    depth.at<float>(9, 10) = bad;
    EXPECT_FALSE(depth_at(depth, {10, 9}, {})) << bad;
  }
}

TEST(DepthAt, RejectsMostlyUnknownNeighbourhoods) {
  cv::Mat depth = flat_depth();
  for (int u = 9; u <= 11; ++u) depth.at<float>(8, u) = depth.at<float>(10, u) = kUnknown;
  EXPECT_FALSE(depth_at(depth, {10, 9}, {}));
}

TEST(DepthAt, RejectsTheBorderAndOutside) {
  const cv::Mat depth = flat_depth();
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(1, 9), {28.6, 9}, {10, 1.4}, {10, 18.5}, {-5, -5}, {1000, 1000}})
    EXPECT_FALSE(depth_at(depth, pixel, {})) << pixel.transpose();
  EXPECT_TRUE(depth_at(depth, {2, 2}, {}));
}

TEST(DepthAt, RejectsDepthEdges) {
  cv::Mat depth = flat_depth();
  depth.colRange(11, 30) = 3.0f;
  EXPECT_FALSE(depth_at(depth, {10, 9}, {}));
  EXPECT_FALSE(depth_at(depth, {11, 9}, {}));
  EXPECT_TRUE(depth_at(depth, {9, 9}, {}));
}

TEST(DepthLookupOptions, NamesTheBadValue) {
  DepthLookupOptions options;
  options.max_edge = 0;
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
