// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

// Row index1 of the first descriptors is the same thing as row index2 of the second.
struct FeatureMatch {
  int index1, index2;
  int distance;  // Hamming, bits
};

// Exact nearest neighbours by Hamming distance that choose each other (cross-check), ordered by index1.
// Ties go to the lower index. Descriptors: CV_8U, a row each, the same number of bytes (a multiple of 8).
std::vector<FeatureMatch> match_brute_force(const cv::Mat& descriptors1, const cv::Mat& descriptors2);

}  // namespace framewise
