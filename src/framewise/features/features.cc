// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/features.h"

#include <opencv2/features2d.hpp>
#include <stdexcept>

namespace framewise {

void FeatureOptions::check() const {
  const auto known = [](const char* option, const std::string& found) {
    if (found != "orb")
      throw std::invalid_argument(std::string(option) + ": found '" + found + "', expected orb");
  };
  known("detector", detector);
  known("descriptor", descriptor);
  if (count < 8)
    throw std::invalid_argument("count: found " + std::to_string(count) + ", expected at least 8");
}

Features extract_features(const cv::Mat& gray, const FeatureOptions& options) {
  Features features;
  const auto orb = cv::ORB::create(options.count);
  orb->detectAndCompute(gray, cv::noArray(), features.keypoints, features.descriptors);
  return features;
}

}  // namespace framewise
