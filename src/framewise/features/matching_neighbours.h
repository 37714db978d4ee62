// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "framewise/features/matching.h"
#include "framewise/features/matching_nearest.h"

namespace framewise {

enum class Metric { kHamming, kL2 };

// Two sets that can be compared: neither is empty.
struct DescriptorPair {
  cv::Mat set1, set2;
  Metric metric;

  // Throws std::invalid_argument where types or lengths do not fit or a component is not finite.
  DescriptorPair(const cv::Mat& descriptors1, const cv::Mat& descriptors2);

  // Distances of row i of set1 to those rows of set2 that are listed, and the other way round.
  void to_listed(int i, const std::vector<int>& listed, std::vector<Key>& keys) const {
    to_listed(set1, i, set2, listed, keys);
  }
  void from_listed(int j, const std::vector<int>& listed, std::vector<Key>& keys) const {
    to_listed(set2, j, set1, listed, keys);
  }

 private:
  void to_listed(const cv::Mat& from, int row, const cv::Mat& to, const std::vector<int>& listed,
                 std::vector<Key>& keys) const;
};

// What a search found, exact or not: an entry for every row.
struct Neighbours {
  std::vector<Nearest> of_set1;
  std::vector<int> of_set2;  // -1: none; empty where nobody asked
};

// Nearest neighbours that pass the tests of options: those that choose each other, by a margin.
std::vector<FeatureMatch> select_matches(Metric metric, const Neighbours& neighbours,
                                         const MatchOptions& options);

}  // namespace framewise
