// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/fast_hessian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace framewise {
namespace {

cv::Mat random_image(const cv::Size& size, std::uint64_t seed) {
  cv::Mat image(size, CV_8U);
  cv::RNG rng(seed);
  rng.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

// A round hump of `height` grey levels over grey.
cv::Mat blob_image(const cv::Size& size, const cv::Point2d& center, double sigma, double height) {
  cv::Mat image(size, CV_8U);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double r2 = (x - center.x) * (x - center.x) + (y - center.y) * (y - center.y);
      image.at<std::uint8_t>(y, x) =
          cv::saturate_cast<std::uint8_t>(120 + height * std::exp(-r2 / (2 * sigma * sigma)));
    }
  return image;
}

int plain_sum(const cv::Mat& image, const cv::Rect& box) { return static_cast<int>(cv::sum(image(box))[0]); }

TEST(IntegralImage, GivesTheSumsOfBoxes) {
  const cv::Mat image = random_image({37, 23}, 1), integral = integral_image(image);
  const Sums sums = sums_of(integral);
  const auto at = [&](int x, int y) { return sums.data[y * sums.stride + x]; };
  for (const cv::Rect& box : {cv::Rect(0, 0, 37, 23), cv::Rect(3, 5, 1, 1), cv::Rect(10, 2, 20, 19)}) {
    const auto sum =
        at(box.br().x, box.br().y) - at(box.x, box.br().y) - at(box.br().x, box.y) + at(box.x, box.y);
    EXPECT_EQ(static_cast<int>(sum), plain_sum(image, box));
  }
}

// Bay et al. 2008, Figure 2, summed pixel by pixel.
BoxDerivatives plain_derivatives(const cv::Mat& image, int filter, int x, int y) {
  const int half = filter / 2, lobe = filter / 3;
  const auto sum = [&](int left, int top, int width, int height) {
    return plain_sum(image, {x + left, y + top, width, height});
  };
  const int yy =
      sum(1 - lobe, -half, 2 * lobe - 1, filter) - 3 * sum(1 - lobe, -(lobe / 2), 2 * lobe - 1, lobe);
  const int xx =
      sum(-half, 1 - lobe, filter, 2 * lobe - 1) - 3 * sum(-(lobe / 2), 1 - lobe, lobe, 2 * lobe - 1);
  const int xy = sum(-lobe, -lobe, lobe, lobe) + sum(1, 1, lobe, lobe) - sum(1, -lobe, lobe, lobe) -
                 sum(-lobe, 1, lobe, lobe);
  const auto area = static_cast<float>(filter * filter);
  return {static_cast<float>(xx) / area, static_cast<float>(yy) / area, static_cast<float>(xy) / area};
}

TEST(BoxHessian, IsTheSumOverItsBoxes) {
  const cv::Mat image = random_image({160, 120}, 2), integral = integral_image(image);
  for (const int filter : {9, 15, 21, 51, 99})
    for (const int step : {1, 2, 4, 8}) {
      const int x = filter / 2, y = filter / 2 + 3, n = (image.cols - filter) / step + 1;
      std::vector<float> determinants(n);
      box_hessian_row(sums_of(integral), filter, x, y, step, n, determinants.data());
      for (int i = 0; i < n; ++i) {
        const BoxDerivatives d = plain_derivatives(image, filter, x + i * step, y);
        const float expected = d.xx * d.yy - 0.81f * d.xy * d.xy;
        EXPECT_NEAR(determinants[i], expected, 1e-3 * (1 + std::abs(expected))) << filter << " " << step;
      }
    }
}

// Sums beyond 2^31 wrap around, and their differences are right again.
TEST(BoxHessian, IsTheSameFarFromTheCornerOfALargeImage) {
  cv::Mat image(3600, 3000, CV_8U, cv::Scalar(255));
  const cv::Mat patch = random_image({40, 40}, 3);
  patch.copyTo(image(cv::Rect(2900, 3500, 40, 40)));
  const cv::Mat integral = integral_image(image), small = integral_image(patch);
  const BoxDerivatives far = box_derivatives(sums_of(integral), 21, 2920, 3520);
  const BoxDerivatives near = box_derivatives(sums_of(small), 21, 20, 20);
  EXPECT_EQ(far.xx, near.xx);
  EXPECT_EQ(far.yy, near.yy);
  EXPECT_EQ(far.xy, near.xy);
}

TEST(FastHessian, FindsABlobAtItsPlaceAndScale) {
  for (const double height : {100.0, -100.0})
    for (const double sigma : {2.5, 3.3, 4.5, 6.0, 9.0, 13.0})
      for (const cv::Point2d shift : {cv::Point2d(0, 0), cv::Point2d(0.5, 0.5), cv::Point2d(-0.3, 0.2)}) {
        const cv::Point2d center = cv::Point2d(160, 120) + shift;
        const auto found =
            detect_fast_hessian(integral_image(blob_image({320, 240}, center, sigma, height)), 1);
        ASSERT_FALSE(found.empty()) << sigma;
        EXPECT_LT(cv::norm(cv::Point2d(found[0].pt) - center), 0.2) << sigma << " " << shift;
        EXPECT_NEAR(found[0].size * 1.2 / 9, 0.71 * sigma, 0.08 * sigma);
        EXPECT_EQ(found[0].class_id, height > 0 ? 1 : -1);
        if (found.size() > 1) {
          EXPECT_LT(found[1].response, 0.2f * found[0].response) << "found twice";
        }
      }
}

TEST(FastHessian, FindsNothingInAnEdgeOrAFlatImage) {
  cv::Mat edge(200, 200, CV_8U, cv::Scalar(0));
  edge.colRange(100, 200).setTo(255);
  EXPECT_TRUE(detect_fast_hessian(integral_image(edge), 1).empty());
  EXPECT_TRUE(detect_fast_hessian(integral_image(cv::Mat(200, 200, CV_8U, cv::Scalar(255))), 1).empty());
}

TEST(FastHessian, FindsNothingInImagesSmallerThanItsFilters) {
  for (const cv::Size& size : {cv::Size(1, 1), cv::Size(8, 300), cv::Size(27, 27), cv::Size(300, 9)})
    EXPECT_TRUE(detect_fast_hessian(integral_image(random_image(size, 4)), 0).empty()) << size;
}

TEST(FastHessian, KeepsTheStrongestFirst) {
  const auto found = detect_fast_hessian(integral_image(random_image({200, 150}, 5)), 1);
  ASSERT_GT(found.size(), 20u);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const auto& a, const auto& b) { return a.response > b.response; }));
}

}  // namespace
}  // namespace framewise
