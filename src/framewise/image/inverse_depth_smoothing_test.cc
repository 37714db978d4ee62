// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/inverse_depth_smoothing.h"

#include <gtest/gtest.h>

#include "framewise/image/depth_images_for_tests.h"

namespace framewise {
namespace {

cv::Mat holed_depth(int width, int height, unsigned seed) {
  cv::Mat depth = random_depth(width, height, seed);
  std::mt19937 random(seed);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      if (random() % 4 == 0) depth.at<float>(v, u) = kNoDepth;
  return depth;
}

// The weights of the three boxes, one after the other.
std::vector<double> kernel_of(const std::array<int, 3>& boxes) {
  std::vector<double> kernel{1};
  for (const int box : boxes) {
    std::vector<double> wider(kernel.size() + box - 1, 0);
    for (std::size_t i = 0; i < kernel.size(); ++i)
      for (int k = 0; k < box; ++k) wider[i + k] += kernel[i] / box;
    kernel = wider;
  }
  return kernel;
}

TEST(GaussianBoxes, AreNearestToTheSigmaAskedFor) {
  for (double sigma = kLeastSmoothing; sigma <= kMostSmoothing; sigma += 0.1)
    EXPECT_NEAR(sigma_of_boxes(gaussian_boxes(sigma)), sigma, 0.22) << sigma;
  for (const double sigma : {-1.0, 0.0, 0.5, 17.0, std::nan("")})
    EXPECT_THROW(gaussian_boxes(sigma), std::invalid_argument) << sigma;
}

TEST(GaussianBoxes, AreNearlyAGaussian) {
  for (const double sigma : {2.0, 5.0, 10.0}) {
    const auto boxes = gaussian_boxes(sigma);
    const std::vector<double> kernel = kernel_of(boxes);
    const double s = sigma_of_boxes(boxes), middle = (kernel.size() - 1) / 2.0;
    const double peak = 1 / (s * std::sqrt(2 * M_PI));
    for (std::size_t i = 0; i < kernel.size(); ++i)
      EXPECT_NEAR(kernel[i], peak * std::exp(-(i - middle) * (i - middle) / (2 * s * s)), 0.07 * peak);
  }
}

TEST(InverseDepthSmoothing, IsTheWeightedMeanOverTheKnownPixels) {
  const cv::Mat depth = holed_depth(50, 40, 1);
  for (const double sigma : {0.8, 2.0, 5.0}) {
    const std::vector<double> kernel = kernel_of(gaussian_boxes(sigma));
    const int reach = static_cast<int>(kernel.size()) / 2;
    const cv::Mat smoothed = smooth_inverse_depth(depth, sigma);
    for (int v = 0; v < depth.rows; ++v)
      for (int u = 0; u < depth.cols; ++u) {
        double sum = 0, weights = 0;
        for (int y = std::max(0, v - reach); y <= std::min(v + reach, depth.rows - 1); ++y)
          for (int x = std::max(0, u - reach); x <= std::min(u + reach, depth.cols - 1); ++x)
            if (const float z = depth.at<float>(y, x); !std::isnan(z)) {
              const double weight = kernel[y - v + reach] * kernel[x - u + reach];
              sum += weight / z;
              weights += weight;
            }
        if (std::isnan(depth.at<float>(v, u)) && weights < 0.5) {
          ASSERT_TRUE(std::isnan(smoothed.at<float>(v, u))) << sigma << " " << u << " " << v;
          continue;
        }
        ASSERT_NEAR(smoothed.at<float>(v, u), weights / sum, 4e-6) << sigma << " " << u << " " << v;
      }
  }
}

TEST(InverseDepthSmoothing, LeavesAConstantAsItIs) {
  const cv::Mat depth(40, 50, CV_32F, cv::Scalar(2));
  EXPECT_LT(largest_difference(smooth_inverse_depth(depth, 5), depth), 1e-6);
}

TEST(InverseDepthSmoothing, HealsSpecksAndLeavesHoles) {
  cv::Mat depth(80, 80, CV_32F, cv::Scalar(2));
  depth.at<float>(20, 20) = kNoDepth;
  depth(cv::Rect(40, 40, 30, 30)) = kNoDepth;
  const cv::Mat smoothed = smooth_inverse_depth(depth, 2);
  EXPECT_NEAR(smoothed.at<float>(20, 20), 2, 1e-6);
  for (int v = 44; v < 66; ++v)
    for (int u = 44; u < 66; ++u) EXPECT_TRUE(std::isnan(smoothed.at<float>(v, u)));
}

TEST(InverseDepthSmoothing, OfALonePixelIsItself) {
  cv::Mat depth(40, 50, CV_32F, cv::Scalar(kNoDepth));
  depth.at<float>(20, 30) = 1.7f;
  const cv::Mat smoothed = smooth_inverse_depth(depth, 16);
  EXPECT_NEAR(smoothed.at<float>(20, 30), 1.7f, 1e-6);
  EXPECT_EQ(count_unknown(smoothed), 40 * 50 - 1);
}

TEST(InverseDepthSmoothing, TakesImagesSmallerThanItsReach) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(3, 1), cv::Size(1, 7), cv::Size(5, 4)}) {
    const cv::Mat smoothed = smooth_inverse_depth(cv::Mat(size, CV_32F, cv::Scalar(3)), 16);
    EXPECT_LT(largest_difference(smoothed, cv::Mat(size, CV_32F, cv::Scalar(3))), 1e-6);
  }
  EXPECT_THROW(smooth_inverse_depth({}, 2), std::invalid_argument);
  EXPECT_THROW(smooth_inverse_depth(cv::Mat(4, 4, CV_8U), 2), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
