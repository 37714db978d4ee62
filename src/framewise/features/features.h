// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace framewise {

// Where an image has something to recognise, and what it looks like there.
struct Features {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;  // one row a keypoint; binary (CV_8U) or float (CV_32F)

  // How much coarser than the image's own pixels a feature was found: its position is as much less certain.
  double scale(int index) const { return keypoints[index].size / finest_size; }
  float finest_size = 31;  // keypoint.size at the finest scale (pixels)
};

struct FeatureOptions {
  std::string detector = "orb";
  std::string descriptor = "orb";
  int count = 1000;  // keypoints asked for; more cost time and add weak corners

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Detects and describes. gray: CV_8U. An image without corners gives no features.
Features extract_features(const cv::Mat& gray, const FeatureOptions& options);

}  // namespace framewise
