// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "framewise/features/matching.h"

namespace framewise {

// Random descriptors of every kind that matching treats in its own way.
enum class DescriptorKind { kBits, kWholeNumbers, kFloats };

inline cv::Mat random_descriptors(DescriptorKind kind, int rows, int columns, std::uint64_t seed) {
  cv::Mat descriptors(rows, columns, kind == DescriptorKind::kBits ? CV_8U : CV_32F);
  cv::RNG rng(seed);
  if (rows == 0) return descriptors;
  if (kind == DescriptorKind::kFloats) {
    rng.fill(descriptors, cv::RNG::NORMAL, 0, 1);
    return descriptors;
  }
  cv::Mat bytes(rows, columns, CV_8U);
  rng.fill(bytes, cv::RNG::UNIFORM, 0, 256);
  bytes.convertTo(descriptors, descriptors.type());
  return descriptors;
}

// Rows of `descriptors` in another order, some of them again, each with a little noise.
inline cv::Mat noisy_copies(const cv::Mat& descriptors, int rows, std::uint64_t seed) {
  cv::Mat copies(rows, descriptors.cols, descriptors.type());
  cv::RNG rng(seed);
  for (int i = 0; i < rows; ++i) {
    descriptors.row(rng.uniform(0, descriptors.rows)).copyTo(copies.row(i));
    for (int k = 0; k < 1 + descriptors.cols / 8; ++k) {
      const int at = rng.uniform(0, descriptors.cols);
      if (descriptors.type() == CV_8U)
        copies.at<std::uint8_t>(i, at) ^= static_cast<std::uint8_t>(1 << rng.uniform(0, 8));
      else
        copies.at<float>(i, at) = copies.at<float>(rng.uniform(0, i + 1), at);
    }
  }
  return copies;
}

// The distances as the headers define them.
inline float plain_distance(const cv::Mat& d1, int i, const cv::Mat& d2, int j) {
  if (d1.type() == CV_8U) {
    const std::uint8_t *a = d1.ptr(i), *b = d2.ptr(j);
    int bits = 0;
    for (int k = 0; k < d1.cols; ++k) bits += std::popcount(static_cast<unsigned>(a[k] ^ b[k]));
    return static_cast<float>(bits);
  }
  const float *a = d1.ptr<float>(i), *b = d2.ptr<float>(j);
  float squared = 0;
  for (int k = 0; k < d1.cols; ++k) {
    const float x = a[k] - b[k];
    const volatile float product = x * x;  // rounded before it is added
    squared += product;
  }
  return std::sqrt(squared);
}

inline cv::Mat_<float> plain_distances(const cv::Mat& d1, const cv::Mat& d2) {
  cv::Mat_<float> distances(d1.rows, d2.rows);
  for (int i = 0; i < d1.rows; ++i)
    for (int j = 0; j < d2.rows; ++j) distances(i, j) = plain_distance(d1, i, d2, j);
  return distances;
}

// Matching as the header defines it: two loops over those pairs that `may` match.
template <class May>
std::vector<FeatureMatch> plain_matches(const cv::Mat_<float>& distances, const MatchOptions& options,
                                        May may) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  std::vector<FeatureMatch> nearest1(distances.rows, {-1, -1, kFar}),
      nearest2(distances.cols, {-1, -1, kFar});
  std::vector<FeatureMatch> matches;
  std::vector<float> second(distances.rows, kFar);
  for (int i = 0; i < distances.rows; ++i)
    for (int j = 0; j < distances.cols; ++j) {
      if (!may(i, j)) continue;
      const float distance = distances(i, j);
      second[i] = std::min(second[i], std::max(distance, nearest1[i].distance));
      if (distance < nearest1[i].distance) nearest1[i] = {i, j, distance};
      if (distance < nearest2[j].distance) nearest2[j] = {i, j, distance};
    }
  for (int i = 0; i < distances.rows; ++i) {
    const FeatureMatch& m = nearest1[i];
    if (m.index1 < 0 || (options.cross_check && nearest2[m.index2].index1 != i)) continue;
    if (options.max_ratio == 1 || m.distance < options.max_ratio * second[i]) matches.push_back(m);
  }
  return matches;
}

inline std::vector<FeatureMatch> plain_matches(const cv::Mat& d1, const cv::Mat& d2,
                                               const MatchOptions& options = {}) {
  return plain_matches(plain_distances(d1, d2), options, [](int, int) { return true; });
}

inline bool operator==(const FeatureMatch& a, const FeatureMatch& b) {
  return a.index1 == b.index1 && a.index2 == b.index2 && a.distance == b.distance;
}

}  // namespace framewise
