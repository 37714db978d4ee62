// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/surf_descriptor.h"

#include <gtest/gtest.h>

#include "framewise/features/fast_hessian.h"
#include "framewise/features/synthetic_images_for_tests.h"

namespace framewise {
namespace {

using testing::discs;
using testing::turned;

// In the middle, so that turning and enlarging leaves them in the image.
std::vector<cv::KeyPoint> keypoints_in_the_middle(const cv::Mat& image) {
  std::vector<cv::KeyPoint> kept;
  for (const cv::KeyPoint& k : detect_fast_hessian(integral_image(image), 20))
    if (cv::norm(k.pt - cv::Point2f(160, 160)) < 60 && k.size < 40) kept.push_back(k);
  return kept;
}

double angle_between(double degrees1, double degrees2) {
  return std::abs(std::remainder(degrees1 - degrees2, 360.0));
}

TEST(SurfOrientation, TurnsWithTheImage) {
  const cv::Mat image = discs({320, 320}, 1, 150);
  auto keypoints = keypoints_in_the_middle(image);
  ASSERT_GT(keypoints.size(), 30u);
  orient_surf(integral_image(image), keypoints);
  for (const double degrees : {30.0, 45.0, 90.0, 135.0, 200.0}) {
    const auto warp = turned(image, degrees, 1.0);
    auto moved = keypoints;
    for (cv::KeyPoint& k : moved) k.pt = warp(k.pt);
    orient_surf(integral_image(warp.image), moved);
    int right = 0;
    for (std::size_t i = 0; i < moved.size(); ++i)
      right += angle_between(moved[i].angle, keypoints[i].angle + degrees) < 12;
    EXPECT_GT(right, 0.7 * static_cast<double>(moved.size())) << degrees;
  }
}

TEST(SurfOrientation, PointsUpTheSlope) {
  cv::Mat ramp(200, 200, CV_8U);
  for (int y = 0; y < ramp.rows; ++y)
    for (int x = 0; x < ramp.cols; ++x)
      ramp.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(x / 2 + y / 2);
  std::vector<cv::KeyPoint> keypoints{{100, 100, 20}};
  orient_surf(integral_image(ramp), keypoints);
  EXPECT_NEAR(keypoints[0].angle, 45, 1);
}

TEST(SurfDescriptor, StaysWhenTheImageIsTurnedAndEnlarged) {
  const cv::Mat image = discs({320, 320}, 2, 150);
  const auto keypoints = keypoints_in_the_middle(image);
  ASSERT_GT(keypoints.size(), 30u);
  for (const bool extended : {false, true}) {
    auto straight = keypoints;
    for (cv::KeyPoint& k : straight) k.angle = 0;
    const cv::Mat before = describe_surf(integral_image(image), straight, {extended, false});
    for (const auto& [degrees, enlarged] :
         {std::pair(90.0, 1.0), std::pair(37.0, 1.0), std::pair(0.0, 1.7), std::pair(160.0, 1.3)}) {
      const auto warp = turned(image, degrees, enlarged);
      auto moved = straight;
      for (cv::KeyPoint& k : moved) {
        k.pt = warp(k.pt);
        k.size *= static_cast<float>(enlarged);
        k.angle = static_cast<float>(degrees);
      }
      const cv::Mat after = describe_surf(integral_image(warp.image), moved, {extended, false});
      int near = 0;
      for (int i = 0; i < before.rows; ++i) near += cv::norm(before.row(i), after.row(i)) < 0.35;
      EXPECT_GT(near, 0.95 * before.rows) << degrees << " " << enlarged;
    }
  }
}

TEST(SurfDescriptor, DoesNotSeeBrightnessAndContrast) {
  const cv::Mat image = discs({320, 320}, 3, 150);
  cv::Mat dimmed;
  image.convertTo(dimmed, CV_8U, 0.5, 40);
  auto keypoints = keypoints_in_the_middle(image);
  orient_surf(integral_image(image), keypoints);
  const cv::Mat before = describe_surf(integral_image(image), keypoints);
  const cv::Mat after = describe_surf(integral_image(dimmed), keypoints);
  for (int i = 0; i < before.rows; ++i) EXPECT_LT(cv::norm(before.row(i), after.row(i)), 0.1);
}

TEST(SurfDescriptor, HasUnitLengthAndItsSumsAddUp) {
  const cv::Mat image = discs({320, 320}, 4, 150), integral = integral_image(image);
  auto keypoints = keypoints_in_the_middle(image);
  orient_surf(integral, keypoints);
  const cv::Mat short_rows = describe_surf(integral, keypoints, {false, false});
  const cv::Mat long_rows = describe_surf(integral, keypoints, {true, false});
  ASSERT_EQ(short_rows.cols, 64);
  ASSERT_EQ(long_rows.cols, 128);
  for (int i = 0; i < short_rows.rows; ++i) {
    EXPECT_NEAR(cv::norm(short_rows.row(i)), 1, 1e-5);
    EXPECT_NEAR(cv::norm(long_rows.row(i)), 1, 1e-5);
    // The two halves of each sum of the long row make the short row's, up to its length.
    cv::Mat sums(1, 64, CV_32F);
    for (int k = 0; k < 64; ++k)
      sums.at<float>(k) =
          long_rows.at<float>(i, k / 4 * 8 + k % 4) + long_rows.at<float>(i, k / 4 * 8 + 4 + k % 4);
    EXPECT_LT(cv::norm(sums / cv::norm(sums), short_rows.row(i)), 1e-5);
  }
}

TEST(SurfDescriptor, UprightIsTheAngleZero) {
  const cv::Mat image = discs({320, 320}, 5, 100), integral = integral_image(image);
  auto keypoints = keypoints_in_the_middle(image);
  orient_surf(integral, keypoints);
  const cv::Mat upright = describe_surf(integral, keypoints, {false, true});
  for (cv::KeyPoint& k : keypoints) k.angle = 0;
  const cv::Mat expected = describe_surf(integral, keypoints, {false, false});
  EXPECT_EQ(cv::norm(upright, expected, cv::NORM_INF), 0);
}

TEST(SurfDescriptor, OfPlacesAtTheEdgeAndLargerThanTheImageIsFinite) {
  const cv::Mat image = discs({64, 48}, 6, 20), integral = integral_image(image);
  std::vector<cv::KeyPoint> keypoints{{0, 0, 9, 30}, {63, 47, 15, 200}, {10, 40, 400, 0}, {-50, 500, 20, 0}};
  orient_surf(integral, keypoints);
  EXPECT_TRUE(cv::checkRange(describe_surf(integral, keypoints)));
  const cv::Mat black = integral_image(cv::Mat(64, 48, CV_8U, cv::Scalar(0)));
  orient_surf(black, keypoints);
  EXPECT_EQ(cv::norm(describe_surf(black, keypoints)), 0);
}

}  // namespace
}  // namespace framewise
