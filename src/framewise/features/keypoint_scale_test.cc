// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/keypoint_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/features2d.hpp>

#include "framewise/features/synthetic_images_for_tests.h"

namespace framewise {
namespace {

const cv::Size kImage(640, 480);

// What a detector says of its own keypoints is what its descriptor is to read.
TEST(KeypointScale, OfADetectorsOwnKeypointsComesBack) {
  const cv::Mat image = testing::discs(kImage, 1, 600);
  std::vector<cv::KeyPoint> keypoints;
  cv::SIFT::create(500)->detect(image, keypoints);
  for (const cv::KeyPoint& k : keypoints) {
    const cv::KeyPoint back = keypoint_for(Descriptor::kSift, k, blob_sigma(k, Detector::kSift), kImage);
    const auto level = [](const cv::KeyPoint& p) {
      return 3 * static_cast<std::int8_t>(p.octave) + (p.octave >> 8 & 255);
    };
    EXPECT_NEAR(level(back), level(k), 1);
    EXPECT_NEAR(back.size, std::max(2.0f, k.size), 1e-3f);
  }
  cv::ORB::create(500)->detect(image, keypoints);
  for (const cv::KeyPoint& k : keypoints) {
    const cv::KeyPoint back = keypoint_for(Descriptor::kOrb, k, blob_sigma(k, Detector::kOrb), kImage);
    EXPECT_EQ(back.octave, k.octave);
    EXPECT_NEAR(back.size, k.size, 1e-3f * k.size);
  }
  cv::AKAZE::create()->detect(image, keypoints);
  for (const cv::KeyPoint& k : keypoints) {
    const cv::KeyPoint back = keypoint_for(Descriptor::kAkaze, k, blob_sigma(k, Detector::kAkaze), kImage);
    EXPECT_EQ(back.class_id, k.class_id);
    EXPECT_EQ(back.octave, k.octave);
    EXPECT_EQ(back.size, k.size);
  }
}

TEST(KeypointScale, StaysWithinTheLevelsOfSmallImages) {
  for (const cv::Size& size : {cv::Size(16, 16), cv::Size(79, 200), cv::Size(160, 80), cv::Size(3000, 20)})
    for (const float sigma : {0.01f, 1.0f, 5.0f, 300.0f}) {
      const cv::KeyPoint k(5, 5, 7);
      EXPECT_GE(keypoint_for(Descriptor::kOrb, k, sigma, size).octave, 0);
      EXPECT_GE(keypoint_for(Descriptor::kAkaze, k, sigma, size).class_id, 0);
      const int packed = keypoint_for(Descriptor::kSift, k, sigma, size).octave;
      EXPECT_GE(static_cast<std::int8_t>(packed), -1);
      EXPECT_LE(1 << std::max<int>(0, static_cast<std::int8_t>(packed)),
                std::min(size.width, size.height) / 8);
      EXPECT_GE(packed >> 8, 1);
      EXPECT_LE(packed >> 8, 3);
    }
}

}  // namespace
}  // namespace framewise
