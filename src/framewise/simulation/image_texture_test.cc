// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/image_texture.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace framewise {
namespace {

// Black below, white above, red on the left of both.
cv::Mat flag() {
  cv::Mat image(16, 32, CV_8UC3, cv::Scalar(0, 0, 0));
  image.rowRange(0, 8).setTo(cv::Scalar(255, 255, 255));
  image.colRange(0, 8).setTo(cv::Scalar(0, 0, 255));
  return image;
}

TEST(ImageTexture, BeginsAtItsLowerLeftCornerAndRepeats) {
  const ImageTexture texture(flag());
  for (const float turn : {-3.0f, 0.0f, 2.0f}) {
    EXPECT_FLOAT_EQ(texture.at(0.6f + turn, 0.2f, 0.01f).g, 0) << "black below";
    EXPECT_FLOAT_EQ(texture.at(0.6f, 0.8f + turn, 0.01f).g, 1) << "white above";
    EXPECT_FLOAT_EQ(texture.at(0.1f + turn, 0.8f, 0.01f).r, 1) << "red to the left";
    EXPECT_FLOAT_EQ(texture.at(0.1f + turn, 0.8f, 0.01f).b, 0);
  }
}

TEST(ImageTexture, IsItsMeanLightFromFarAway) {
  const ImageTexture texture(flag());
  for (const float footprint : {1.0f, 1e6f}) {
    EXPECT_NEAR(texture.at(0.3f, 0.7f, footprint).g, 0.375, 0.01);
    EXPECT_NEAR(texture.at(0.8f, 0.1f, footprint).r, 0.625, 0.01);
  }
}

TEST(ImageTexture, BytesAreTakenForWhatTheyShow) {
  const ImageTexture texture(cv::Mat(3, 5, CV_8UC3, cv::Scalar(188, 188, 188)));
  EXPECT_NEAR(texture.at(0.5f, 0.5f, 0.1f).r, 0.5, 0.005);
}

TEST(ImageTexture, RefusesWhatIsNoColourImage) {
  EXPECT_THROW(ImageTexture(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(ImageTexture(cv::Mat(4, 4, CV_8U)), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
