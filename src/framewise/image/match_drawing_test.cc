// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/match_drawing.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace framewise {
namespace {

using Pixels = std::vector<Eigen::Vector2d>;

const cv::Mat kBlack(60, 80, CV_8U, cv::Scalar(0));

bool is_green(const cv::Vec3b& c) { return c[1] > 80 && c[1] > 2 * c[2]; }
bool is_red(const cv::Vec3b& c) { return c[2] > 80 && c[2] > 2 * c[1]; }

TEST(DrawMatches, JoinsInliersInGreenAndOthersInRed) {
  const cv::Mat drawing = draw_matches(kBlack, kBlack, {{10, 20}, {10, 40}}, {{50, 20}, {50, 40}}, {1, 0});
  ASSERT_EQ(drawing.size(), cv::Size(160, 60));
  ASSERT_EQ(drawing.type(), CV_8UC3);
  for (int u = 10; u <= 130; ++u) {
    EXPECT_TRUE(is_green(drawing.at<cv::Vec3b>(20, u))) << u;
    EXPECT_TRUE(is_red(drawing.at<cv::Vec3b>(40, u))) << u;
  }
  // Nothing else is painted.
  cv::Mat elsewhere = drawing.clone();
  for (const int v : {20, 40}) elsewhere.rowRange(v - 3, v + 4).setTo(0);
  EXPECT_EQ(cv::norm(elsewhere, cv::NORM_INF), 0);
}

TEST(DrawMatches, LaysInliersAboveTheOthers) {
  const Pixels same1 = {{10, 20}, {10, 20}}, same2 = {{50, 20}, {50, 20}};
  for (const std::vector<std::uint8_t>& inliers : {std::vector<std::uint8_t>{1, 0}, {0, 1}})
    EXPECT_TRUE(is_green(draw_matches(kBlack, kBlack, same1, same2, inliers).at<cv::Vec3b>(20, 10)));
}

TEST(DrawMatches, NoInliersAtAllAreAllRed) {
  EXPECT_TRUE(is_red(draw_matches(kBlack, kBlack, {{10, 20}}, {{50, 20}}, {}).at<cv::Vec3b>(20, 30)));
}

TEST(DrawMatches, TakesImagesOfTwoSizesAndOfColour) {
  const cv::Mat colour(30, 50, CV_8UC3, cv::Scalar(0, 0, 255));
  const cv::Mat drawing = draw_matches(kBlack, colour, {}, {}, {});
  ASSERT_EQ(drawing.size(), cv::Size(130, 60));
  const auto shown = drawing.at<cv::Vec3b>(10, 100);  // as gray, so that it is no line's colour
  EXPECT_GT(shown[0], 20);
  EXPECT_EQ(shown[0], shown[2]);
  EXPECT_EQ(drawing.at<cv::Vec3b>(45, 100), cv::Vec3b(0, 0, 0));
}

TEST(DrawMatches, LeavesOutWhatIsOutsideTheImages) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Pixels outside = {{-1, 5}, {80, 5}, {5, 1e12}, {nan, 5}}, inside(4, {5, 5});
  EXPECT_EQ(cv::norm(draw_matches(kBlack, kBlack, outside, inside, {1, 1, 1, 1}), cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(draw_matches(kBlack, kBlack, inside, outside, {1, 1, 1, 1}), cv::NORM_INF), 0);
}

TEST(DrawMatches, RefusesWhatDoesNotFitTogether) {
  EXPECT_THROW(draw_matches(kBlack, kBlack, {{1, 1}}, {}, {}), std::invalid_argument);
  EXPECT_THROW(draw_matches(kBlack, kBlack, {{1, 1}}, {{1, 1}}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(draw_matches(cv::Mat(), kBlack, {}, {}, {}), std::invalid_argument);
  EXPECT_THROW(draw_matches(kBlack, cv::Mat(), {}, {}, {}), std::invalid_argument);
  EXPECT_THROW(draw_matches(kBlack, cv::Mat(9, 9, CV_32F), {}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
