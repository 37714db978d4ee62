// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/gray_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace framewise {
namespace {

int gray_of(const cv::Mat& image) {
  const cv::Mat gray = gray_image(image);
  EXPECT_EQ(gray.type(), CV_8UC1);
  EXPECT_EQ(gray.size(), image.size());
  return gray.at<std::uint8_t>(1, 1);
}

TEST(GrayImage, OfEqualChannelsIsTheirValue) {
  for (const int channels : {1, 3, 4}) {
    EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_8UC(channels), cv::Scalar::all(77))), 77);
    EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_16UC(channels), cv::Scalar::all(77 * 257))), 77);
    EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_16UC(channels), cv::Scalar::all(65535))), 255);
  }
}

TEST(GrayImage, WeighsColoursAndLeavesAlphaOut) {
  EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_8UC3, cv::Scalar(255, 0, 0))), 29);  // 0.114, 0.587, 0.299
  EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_8UC3, cv::Scalar(0, 255, 0))), 150);
  EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_8UC3, cv::Scalar(0, 0, 255))), 76);
  for (const int alpha : {0, 128, 255})
    EXPECT_EQ(gray_of(cv::Mat(3, 4, CV_8UC4, cv::Scalar(0, 255, 0, alpha))), 150);
}

TEST(GrayImage, SharesWhatIsGrayAlready) {
  const cv::Mat image(3, 4, CV_8U, cv::Scalar(9));
  EXPECT_EQ(gray_image(image).data, image.data);
  EXPECT_TRUE(gray_image(cv::Mat()).empty());
}

TEST(GrayImage, RefusesPixelsOfUnknownRange) {
  for (const int type : {CV_32FC1, CV_64FC3, CV_16SC1, CV_8SC1, CV_8UC2, CV_16UC(5), CV_32SC1})
    EXPECT_THROW(gray_image(cv::Mat(3, 4, type)), std::invalid_argument) << type;
  try {
    gray_image(cv::Mat(3, 4, CV_32FC2));
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("found 2 channel(s) of 32 bits, floating point, expected"));
  }
}

}  // namespace
}  // namespace framewise
