// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching_neighbours.h"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "framewise/features/hamming.h"
#include "framewise/features/l2.h"

namespace framewise {
namespace {

// A distance is at most 2^23 bits: a float holds it.
constexpr int kMaxComponents = 1 << 20;

std::string size_of(const cv::Mat& m) {
  if (m.dims > 2) return "a matrix of " + std::to_string(m.dims) + " dimensions";
  return cv::typeToString(m.type()) + " of " + std::to_string(m.cols) + " columns";
}

void check_finite(const char* name, const cv::Mat& descriptors) {
  cv::Point at;
  if (cv::checkRange(descriptors, true, &at)) return;
  throw std::invalid_argument(std::string(name) + ": found " +
                              std::to_string(descriptors.at<float>(at.y, at.x)) + " in row " +
                              std::to_string(at.y) + ", expected finite values");
}

float distance_of(Metric metric, Key key) {
  if (key == INT_MAX) return std::numeric_limits<float>::infinity();
  return metric == Metric::kHamming ? static_cast<float>(key) : std::sqrt(std::bit_cast<float>(key));
}

}  // namespace

DescriptorPair::DescriptorPair(const cv::Mat& descriptors1, const cv::Mat& descriptors2)
    : set1(descriptors1), set2(descriptors2), metric(Metric::kHamming) {
  const bool fit = set1.dims <= 2 && set2.dims <= 2 && set1.type() == set2.type() && set1.cols == set2.cols &&
                   set1.cols <= kMaxComponents && (set1.type() == CV_8U || set1.type() == CV_32F);
  if (!fit)
    throw std::invalid_argument("descriptors: found " + size_of(set1) + " and " + size_of(set2) +
                                ", expected CV_8UC1 or CV_32FC1 twice with as many columns, at most " +
                                std::to_string(kMaxComponents));
  if (set1.type() == CV_8U) return;
  metric = Metric::kL2;
  check_finite("descriptors1", set1);
  check_finite("descriptors2", set2);
}

void DescriptorPair::to_listed(const cv::Mat& from, int row, const cv::Mat& to,
                               const std::vector<int>& listed, std::vector<Key>& keys) const {
  const int count = static_cast<int>(listed.size());
  keys.resize(listed.size());
  if (metric == Metric::kHamming)
    hamming_to_listed(from.ptr(row), to.data, static_cast<std::int64_t>(to.step[0]), to.cols, listed.data(),
                      count, keys.data());
  else
    l2_to_listed(from.ptr<float>(row), to.ptr<float>(), static_cast<std::int64_t>(to.step1()), to.cols,
                 listed.data(), count, keys.data());
}

std::vector<FeatureMatch> select_matches(Metric metric, const Neighbours& neighbours,
                                         const MatchOptions& options) {
  std::vector<FeatureMatch> matches;
  matches.reserve(neighbours.of_set1.size());
  for (int i = 0; i < static_cast<int>(neighbours.of_set1.size()); ++i) {
    const Nearest& nearest = neighbours.of_set1[i];
    if (nearest.index < 0) continue;
    if (options.cross_check && neighbours.of_set2[nearest.index] != i) continue;
    const float distance = distance_of(metric, nearest.key);
    if (options.max_ratio < 1 && !(distance < options.max_ratio * distance_of(metric, nearest.second)))
      continue;
    matches.push_back({i, nearest.index, distance});
  }
  return matches;
}

}  // namespace framewise
