// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace framewise {

// Where an image has something to recognise, and what it looks like there.
struct Features {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;  // one row a keypoint; binary (CV_8U, whole 64-bit words) or float (CV_32F)

  // How much coarser than the finest a feature was found: its position is as much less certain.
  double scale(int index) const { return std::max(1.0f, keypoints[index].size / finest_size); }
  float finest_size = 31;  // keypoint.size at the detector's finest scale (pixels)
};

struct FeatureOptions {
  std::string detector = "orb";    // sift, surf, orb, akaze
  std::string descriptor = "orb";  // sift, surf, surf-128, orb, akaze: any with any detector
  int count = 1000;                // keypoints asked for; more cost time and add weak corners
  std::string spread = "none";     // over the image: none (the strongest), grid or anms (spread.h)
  // Descriptors are not turned into the keypoint's direction: more tell each other apart, and a roll of the
  // camera beyond some 15 degrees is no longer seen through.
  bool upright = false;
  bool describe = true;  // false: keypoints alone, as tracking needs them; descriptors stay empty

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Detects and describes. gray: CV_8U; mask: empty, or CV_8U of the same size, 0 where nothing is to be found.
// An image without anything to recognise gives no features. The same image and options give the same bytes
// with any number of threads. Throws std::invalid_argument on other types and sizes.
Features extract_features(const cv::Mat& gray, const FeatureOptions& options, const cv::Mat& mask = {});

}  // namespace framewise
