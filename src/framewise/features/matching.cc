// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching.h"

#include <climits>
#include <stdexcept>

#include "framewise/features/hamming.h"

namespace framewise {

std::vector<FeatureMatch> match_brute_force(const cv::Mat& descriptors1, const cv::Mat& descriptors2) {
  if (descriptors1.empty() || descriptors2.empty()) return {};
  const int bytes = descriptors1.cols;
  if (descriptors1.type() != CV_8U || descriptors2.type() != CV_8U || bytes != descriptors2.cols ||
      bytes % 8 != 0)
    throw std::invalid_argument(
        "descriptors: expected two CV_8U matrices with the same multiple of 8 columns");

  const cv::Mat d1 = descriptors1.isContinuous() ? descriptors1 : descriptors1.clone();
  const cv::Mat d2 = descriptors2.isContinuous() ? descriptors2 : descriptors2.clone();
  std::vector<Nearest> nearest1(d1.rows, {-1, INT_MAX}), nearest2(d2.rows, {-1, INT_MAX});
  nearest_by_hamming(d1.data, d1.rows, d2.data, d2.rows, bytes / 8, nearest1.data(), nearest2.data());

  std::vector<FeatureMatch> matches;
  matches.reserve(d1.rows);
  for (int i = 0; i < d1.rows; ++i) {
    const auto [j, distance] = nearest1[i];
    if (nearest2[j].index == i) matches.push_back({i, j, distance});
  }
  return matches;
}

}  // namespace framewise
