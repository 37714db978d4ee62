// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/input_image.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace framewise {
namespace {

const Camera kCamera{CameraModel::kPinhole, 160, 120, 130, 130, 79.5, 59.5};

// A step in depth, a hole in it, and a colour image that has nothing to do with either.
Frame frame() {
  Frame frame;
  frame.gray = cv::Mat(120, 160, CV_8U, cv::Scalar(77));
  frame.depth = cv::Mat(120, 160, CV_32F, cv::Scalar(2.0f));
  frame.depth.colRange(80, 160) = 3.0f;
  frame.depth(cv::Rect(100, 40, 20, 20)) = std::numeric_limits<float>::quiet_NaN();
  return frame;
}

TEST(InputImage, ColorIsTheGrayImageItself) {
  const Frame f = frame();
  EXPECT_EQ(InputImage("color", kCamera, 8).of(f).data, f.gray.data);
}

TEST(InputImage, TheOthersComeFromDepthAloneWithItsSize) {
  for (const char* name : {"depth-raw", "depth", "flexion-published", "flexion", "normal"}) {
    const InputImage input(name, kCamera, 8);
    Frame f = frame();
    const cv::Mat image = input.of(f);
    ASSERT_EQ(image.type(), CV_8U) << name;
    ASSERT_EQ(image.size(), f.depth.size()) << name;
    double low, high;
    cv::minMaxLoc(image, &low, &high);
    EXPECT_LT(low, high) << name;
    f.gray = cv::Mat();
    EXPECT_EQ(cv::norm(image, input.of(f), cv::NORM_INF), 0) << name;
    f.depth = cv::Mat();
    EXPECT_TRUE(input.of(f).empty()) << name;
  }
}

TEST(InputImage, DepthIsFilledAndRawDepthIsNot) {
  const Frame f = frame();
  EXPECT_EQ(InputImage("depth-raw", kCamera, 8).of(f).at<std::uint8_t>(50, 110), 0);
  EXPECT_GT(InputImage("depth", kCamera, 8).of(f).at<std::uint8_t>(50, 110), 0);
  // Linear in depth: 3 m of 8.
  EXPECT_NEAR(InputImage("depth-raw", kCamera, 8).of(f).at<std::uint8_t>(10, 150), 1 + 254 * 3.0 / 8, 1);
}

TEST(InputImage, RefusesNamesItDoesNotKnow) {
  EXPECT_THROW(InputImage("infrared", kCamera, 8), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
