// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace framewise {

// Row index1 of the first descriptors is the same thing as row index2 of the second.
struct FeatureMatch {
  int index1, index2;
  float distance;  // Hamming: bits; L2: in the descriptors' own unit
};

// The approximate search of FLANN: Muja, Lowe, Fast approximate nearest neighbors with automatic algorithm
// configuration, VISAPP 2009; LSH: Lv et al., Multi-probe LSH, VLDB 2007.
struct FlannOptions {
  int trees = 4;           // float descriptors: randomised KD-trees; more find more and take longer
  int checks = 64;         // float descriptors: leaves looked at for one descriptor
  int lsh_tables = 6;      // binary descriptors: hash tables
  int lsh_key_bits = 12;   // binary descriptors: bits of a hash; about log2 of the number of descriptors
  int lsh_probe_bits = 1;  // binary descriptors: hashes that differ by so many bits are looked at too

  // Throws std::invalid_argument that names the value.
  void check() const;
};

struct MatchOptions {
  std::string matcher = "brute-force";  // brute-force: exact; flann: approximate
  bool cross_check = true;              // both must choose each other: for either there is one match at most
  double max_ratio = 1;    // nearest / second nearest distance must be below (Lowe 2004 takes 0.8); 1: any
  double window_px = 40;   // match_windowed: how far from its predicted position a feature may be (pixels)
  std::uint64_t seed = 0;  // of flann's random trees and hashes
  FlannOptions flann;

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Matches of two sets of descriptors, a row each: CV_8U by Hamming distance, CV_32F by L2; of any length, the
// same in both. In the order of index1; among equal distances the lower index wins. Empty sets have no
// matches. The same input and options give the same matches, whatever the processor and however many threads
// call.
//   ratio test: Lowe, Distinctive image features from scale-invariant keypoints, IJCV 2004, section 7.1. What
//   has no second candidate passes it.
std::vector<FeatureMatch> match_features(const cv::Mat& descriptors1, const cv::Mat& descriptors2,
                                         const MatchOptions& options = {});

// The same with the default options: exact, cross-checked.
std::vector<FeatureMatch> match_brute_force(const cv::Mat& descriptors1, const cv::Mat& descriptors2);

}  // namespace framewise
