// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/contrast_to_noise.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

cv::Mat noisy(double contrast, double sigma) {
  cv::Mat image(240, 320, CV_32F), noise(240, 320, CV_32F);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
      image.at<float>(v, u) = static_cast<float>(100 + contrast * std::sin(0.2 * u) * std::cos(0.15 * v));
  cv::RNG random(1);
  random.fill(noise, cv::RNG::NORMAL, 0, sigma);
  cv::Mat gray;
  cv::Mat(image + noise).convertTo(gray, CV_8U);
  return gray;
}

TEST(ContrastToNoise, IsOneForNoiseAlone) { EXPECT_NEAR(contrast_to_noise(noisy(0, 8)), 1, 0.15); }

TEST(ContrastToNoise, FallsAsNoiseRises) {
  const double day = contrast_to_noise(noisy(40, 1)), dusk = contrast_to_noise(noisy(40, 10)),
               night = contrast_to_noise(noisy(4, 20));
  EXPECT_GT(day, 2 * dusk);
  EXPECT_GT(dusk, 2 * night);
  EXPECT_GT(day, 20);
  EXPECT_LT(night, 3);
}

TEST(ContrastToNoise, IsNothingForBlackEmptyAndTinyImages) {
  EXPECT_EQ(contrast_to_noise(cv::Mat()), 0);
  EXPECT_EQ(contrast_to_noise(cv::Mat(1, 1, CV_8U, cv::Scalar(5))), 0);
  EXPECT_EQ(contrast_to_noise(cv::Mat(240, 320, CV_8U, cv::Scalar(0))), 0);
}

}  // namespace
}  // namespace framewise
