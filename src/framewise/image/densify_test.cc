// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/densify.h"

#include <gtest/gtest.h>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

DepthSource source_of(const DenseDepth& dense, int v, int u) {
  return static_cast<DepthSource>(dense.mask.at<std::uint8_t>(v, u));
}

// Every fifth row, every second column of it.
cv::Mat scanned(const cv::Mat& depth) {
  cv::Mat sparse(depth.size(), CV_32F, cv::Scalar(kNoDepth));
  for (int v = 2; v < depth.rows; v += 5)
    for (int u = 0; u < depth.cols; u += 2) sparse.at<float>(v, u) = depth.at<float>(v, u);
  return sparse;
}

TEST(Densify, ReturnsMeasuredPixelsUnchangedAndSaysWhatEveryPixelIs) {
  const cv::Mat sparse = scanned(random_depth(64, 48, 1));
  const DenseDepth dense = densify(sparse, {});
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u) {
      if (sparse.at<float>(v, u) > 0) {
        EXPECT_EQ(dense.depth.at<float>(v, u), sparse.at<float>(v, u));
        EXPECT_EQ(source_of(dense, v, u), DepthSource::kMeasured);
      } else {
        EXPECT_EQ(source_of(dense, v, u) == DepthSource::kUnknown, std::isnan(dense.depth.at<float>(v, u)));
        EXPECT_NE(source_of(dense, v, u), DepthSource::kMeasured);
      }
    }
}

TEST(Densify, FindsAPlaneBetweenTheLinesOfAScanner) {
  const DepthRays rays(pinhole_camera(128, 96), DepthType::kZ);
  const cv::Mat plane = plane_depth(rays, {0.2, 0.1, 1}, 2);
  const DenseDepth dense = densify(scanned(plane), {});
  EXPECT_EQ(count_unknown(dense.depth), 0);
  // Away from the border every pixel has samples on all sides.
  const cv::Rect inner(6, 8, 116, 80);
  EXPECT_LT(largest_difference(dense.depth(inner), plane(inner)), 5e-3);
}

TEST(Densify, KeepsAnEdgeSharp) {
  cv::Mat depth(48, 64, CV_32F, cv::Scalar(2));
  depth.colRange(32, 64) = 6;
  const cv::Mat dense = densify(scanned(depth), {}).depth;
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u)
      EXPECT_TRUE(std::abs(dense.at<float>(v, u) - 2) < 0.02 || std::abs(dense.at<float>(v, u) - 6) < 0.2)
          << u << " " << v << " " << dense.at<float>(v, u);
}

TEST(Densify, KnowsNothingBeyondItsReach) {
  cv::Mat depth(40, 40, CV_32F, cv::Scalar(kNoDepth));
  depth(cv::Rect(19, 19, 2, 2)) = 3;
  const DenseDepth dense = densify(depth, {});
  for (int v = 0; v < 40; ++v)
    for (int u = 0; u < 40; ++u) {
      const double nearest = std::hypot(std::max({19 - u, u - 20, 0}), std::max({19 - v, v - 20, 0}));
      if (nearest > 10) {
        EXPECT_EQ(source_of(dense, v, u), DepthSource::kUnknown);
      }
      if (nearest < 8 && nearest > 0) {
        EXPECT_EQ(source_of(dense, v, u), DepthSource::kInterpolated);
      }
    }
}

TEST(Densify, OfNothingIsNothing) {
  const DenseDepth dense = densify(cv::Mat(6, 7, CV_32F, cv::Scalar(kNoDepth)), {});
  EXPECT_EQ(count_unknown(dense.depth), 42);
  EXPECT_EQ(cv::countNonZero(dense.mask), 0);
  EXPECT_EQ(densify(cv::Mat(1, 1, CV_32F, cv::Scalar(2)), {}).depth.at<float>(0, 0), 2);
  EXPECT_THROW(densify({}, {}), std::invalid_argument);
  EXPECT_THROW(densify(cv::Mat(6, 7, CV_16U), {}), std::invalid_argument);
  DensifyOptions options;
  options.max_reach_px = 0;
  EXPECT_THROW(densify(cv::Mat(6, 7, CV_32F), options), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
