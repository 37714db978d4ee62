// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching_flann.h"

#include <algorithm>
#include <opencv2/flann.hpp>

namespace framewise {
namespace {

// FLANN draws from OpenCV's generator of the calling thread: seeded while it works, put back after.
class SeededGenerator {
 public:
  explicit SeededGenerator(std::uint64_t seed) : before_(cv::theRNG()) { cv::theRNG() = cv::RNG(seed); }
  ~SeededGenerator() { cv::theRNG() = before_; }
  SeededGenerator(const SeededGenerator&) = delete;
  SeededGenerator& operator=(const SeededGenerator&) = delete;

 private:
  cv::RNG before_;
};

// One piece of memory. Hashing reads whole 64-bit words, so there is more of it than there are rows.
cv::Mat with_slack(const cv::Mat& descriptors) {
  cv::Mat rows(descriptors.rows + 8, descriptors.cols, descriptors.type(), cv::Scalar(0));
  descriptors.copyTo(rows.rowRange(0, descriptors.rows));
  return rows.rowRange(0, descriptors.rows);
}

// The two rows of `set` that FLANN holds for the nearest to each query: CV_32S, -1 for none.
cv::Mat two_nearest(const cv::Mat& set, const cv::Mat& queries, Metric metric, const MatchOptions& options) {
  const SeededGenerator generator(options.seed);
  const FlannOptions& o = options.flann;
  const int wanted = std::min(2, set.rows);
  cv::Mat indices(queries.rows, wanted, CV_32S, cv::Scalar(-1)), distances;
  if (metric == Metric::kHamming) {
    const int key_bits = std::min(o.lsh_key_bits, 8 * set.cols);
    cv::flann::Index index(set, cv::flann::LshIndexParams(o.lsh_tables, key_bits, o.lsh_probe_bits),
                           cvflann::FLANN_DIST_HAMMING);
    index.knnSearch(queries, indices, distances, wanted);
  } else {
    cv::flann::Index index(set, cv::flann::KDTreeIndexParams(o.trees), cvflann::FLANN_DIST_L2);
    index.knnSearch(queries, indices, distances, wanted, cv::flann::SearchParams(o.checks));
  }
  return indices;
}

// The indices that are some.
void list(const cv::Mat& indices, int row, int rows, std::vector<int>& listed) {
  listed.clear();
  for (int k = 0; k < indices.cols; ++k) {
    const int index = indices.at<int>(row, k);
    if (index >= 0 && index < rows) listed.push_back(index);
  }
}

Nearest nearest_of(const std::vector<int>& listed, const std::vector<Key>& keys) {
  Nearest nearest;
  for (std::size_t k = 0; k < listed.size(); ++k) nearest.see(listed[k], keys[k]);
  return nearest;
}

}  // namespace

Neighbours flann_neighbours(const DescriptorPair& pair, const MatchOptions& options) {
  const cv::Mat set1 = with_slack(pair.set1), set2 = with_slack(pair.set2);
  Neighbours neighbours;
  std::vector<int> listed;
  std::vector<Key> keys;  // exact and as every matcher has them: FLANN's own sums are in another order
  const cv::Mat in_set2 = two_nearest(set2, set1, pair.metric, options);
  for (int i = 0; i < set1.rows; ++i) {
    list(in_set2, i, set2.rows, listed);
    pair.to_listed(i, listed, keys);
    neighbours.of_set1.push_back(nearest_of(listed, keys));
  }
  if (!options.cross_check) return neighbours;
  const cv::Mat in_set1 = two_nearest(set1, set2, pair.metric, options);
  for (int j = 0; j < set2.rows; ++j) {
    list(in_set1, j, set1.rows, listed);
    pair.from_listed(j, listed, keys);
    neighbours.of_set2.push_back(nearest_of(listed, keys).index);
  }
  return neighbours;
}

}  // namespace framewise
