// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching.h"

#include <stdexcept>

#include "framewise/features/matching_exact.h"
#include "framewise/features/matching_flann.h"

namespace framewise {
namespace {

void check_range(const char* option, double found, double from, double to) {
  if (found >= from && found <= to) return;
  throw std::invalid_argument(std::string(option) + ": found " + std::to_string(found) + ", expected " +
                              std::to_string(from) + " to " + std::to_string(to));
}

}  // namespace

void FlannOptions::check() const {
  check_range("flann.trees", trees, 1, 256);
  check_range("flann.checks", checks, 1, 1e9);
  check_range("flann.lsh_tables", lsh_tables, 1, 256);
  check_range("flann.lsh_key_bits", lsh_key_bits, 1, 30);
  check_range("flann.lsh_probe_bits", lsh_probe_bits, 0, 3);
}

void MatchOptions::check() const {
  if (matcher != "brute-force" && matcher != "flann")
    throw std::invalid_argument("matcher: found '" + matcher + "', expected brute-force or flann");
  check_range("max_ratio", max_ratio, 1e-6, 1);
  check_range("window_px", window_px, 1e-6, 1e6);
  flann.check();
}

std::vector<FeatureMatch> match_features(const cv::Mat& descriptors1, const cv::Mat& descriptors2,
                                         const MatchOptions& options) {
  options.check();
  if (descriptors1.empty() || descriptors2.empty()) return {};
  const DescriptorPair pair(descriptors1, descriptors2);
  const Neighbours neighbours = options.matcher == "flann"
                                    ? flann_neighbours(pair, options)
                                    : exact_neighbours(pair, options.cross_check, best_instructions());
  return select_matches(pair.metric, neighbours, options);
}

std::vector<FeatureMatch> match_brute_force(const cv::Mat& descriptors1, const cv::Mat& descriptors2) {
  return match_features(descriptors1, descriptors2);
}

}  // namespace framewise
