// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "framewise/features/feature_names.h"

namespace framewise {

struct DetectOptions {
  Detector detector = Detector::kOrb;
  int count = 1000;           // keypoints wanted
  int candidates = 1000;      // and given where there are more to choose from
  bool upright = false;       // angles are 0
  bool describe_too = false;  // with the detector's own descriptor, where both take one pass of OpenCV's
};

struct Detection {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;  // a row for each, or empty
};

// The strongest keypoints of an image (CV_8U), strongest first but for ORB's, which come by level.
// The threshold is set by what the image holds: guessed from its blob strengths, lowered where that found
// less than nine tenths of `count`, never below what noise makes. Fewer are found where the image has no
// more. mask (CV_8U, or empty): 0 where nothing is looked for. Depends on nothing but its arguments.
Detection detect(const cv::Mat& gray, const cv::Mat& mask, const DetectOptions& options);

}  // namespace framewise
