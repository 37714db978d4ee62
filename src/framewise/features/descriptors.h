// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "framewise/features/feature_names.h"

namespace framewise {

// A row for every keypoint, whichever detector found it (keypoint_scale.h says what its size means then):
// sift 128, surf 64 and surf-128 128 values (CV_32F); orb 32 and akaze 64 bytes (CV_8U; the last 26 of
// akaze's bits are 0, so that rows are whole 64-bit words). Keypoints that the descriptor cannot read (orb:
// nearer than 16 pixels to the image's edge) are taken out; the others keep their order, place, size and
// angle. gray: CV_8U. Turned by the keypoints' angles, or upright.
cv::Mat describe(const cv::Mat& gray, std::vector<cv::KeyPoint>& keypoints, Detector detector,
                 Descriptor descriptor, bool upright);

// AKAZE's rows of 61 bytes filled up with zeros to 64, which changes no Hamming distance.
cv::Mat in_whole_words(const cv::Mat& binary_descriptors);

}  // namespace framewise
