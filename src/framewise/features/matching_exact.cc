// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/matching_exact.h"

#include <algorithm>
#include <cstring>

#include "framewise/features/hamming.h"
#include "framewise/features/l2.h"

namespace framewise {
namespace {

// Descriptors as rows of cells, see matching_blocks.h: CV_32S.
struct Cells {
  cv::Mat set1, set2;
  BlockKernel kernel;
};

cv::Mat cells_of_bits(const cv::Mat& descriptors) {
  cv::Mat cells(descriptors.rows, (descriptors.cols + 3) / 4 * 2, CV_32S);
  for (int i = 0; i < cells.rows; ++i)
    for (int k = 0; k < cells.cols; k += 2) {
      std::uint32_t word = 0;
      std::memcpy(&word, descriptors.ptr(i) + 2 * k, std::min(4, descriptors.cols - 2 * k));
      cells.at<std::int32_t>(i, k) = static_cast<std::int32_t>(word & 0x0f0f0f0fu);
      cells.at<std::int32_t>(i, k + 1) = static_cast<std::int32_t>(word >> 4 & 0x0f0f0f0fu);
    }
  return cells;
}

// Empty where a component is no whole number from 0 to 255.
cv::Mat cells_of_bytes(const cv::Mat& descriptors) {
  const int last = (descriptors.cols + 1) / 2;
  cv::Mat cells(descriptors.rows, last + 1, CV_32S, cv::Scalar(0));
  for (int i = 0; i < cells.rows; ++i) {
    const float* from = descriptors.ptr<float>(i);
    std::int32_t* to = cells.ptr<std::int32_t>(i);
    bool whole = true;
    for (int k = 0; k < descriptors.cols; ++k) {
      const float inside = from[k] >= 0 && from[k] <= 255 ? from[k] : 0.0f;
      const std::int32_t value = static_cast<std::int32_t>(inside);
      whole &= static_cast<float>(value) == from[k];
      to[k / 2] += value << 16 * (k % 2);
      to[last] += value * value;
    }
    if (!whole) return {};
  }
  return cells;
}

cv::Mat cells_of_floats(const cv::Mat& descriptors) {
  cv::Mat cells(descriptors.size(), CV_32S);
  for (int i = 0; i < cells.rows; ++i)
    std::memcpy(cells.ptr(i), descriptors.ptr(i), sizeof(float) * descriptors.cols);
  return cells;
}

Cells cells_of(const DescriptorPair& pair, Instructions instructions) {
  if (pair.metric == Metric::kHamming)
    return {cells_of_bits(pair.set1), cells_of_bits(pair.set2), hamming_kernel(instructions)};
  if (l2_byte_kernel(instructions) && pair.set1.cols <= kMaxByteComponents) {
    Cells bytes{cells_of_bytes(pair.set1), {}, l2_byte_kernel(instructions)};
    if (!bytes.set1.empty()) bytes.set2 = cells_of_bytes(pair.set2);
    if (!bytes.set2.empty()) return bytes;
  }
  return {cells_of_floats(pair.set1), cells_of_floats(pair.set2), l2_kernel(instructions)};
}

cv::Mat blocks_of(const cv::Mat& cells) {
  const int block_count = (cells.rows + kBlockRows - 1) / kBlockRows;
  cv::Mat blocks(block_count * cells.cols, kBlockRows, CV_32S, cv::Scalar(0));
  for (int i = 0; i < cells.rows; ++i) {
    const std::int32_t* from = cells.ptr<std::int32_t>(i);
    std::int32_t* to = blocks.ptr<std::int32_t>(i / kBlockRows * cells.cols) + i % kBlockRows;
    for (int k = 0; k < cells.cols; ++k) to[k * kBlockRows] = from[k];
  }
  return blocks;
}

}  // namespace

BlockDistances::BlockDistances(const DescriptorPair& pair, Instructions instructions) {
  const Cells cells = cells_of(pair, instructions);
  rows1_ = cells.set1;
  blocks2_ = blocks_of(cells.set2);
  n2_ = cells.set2.rows;
  kernel_ = cells.kernel;
}

AllPairs BlockDistances::all_pairs() const {
  return {kernel_,     rows1_.ptr<std::int32_t>(),   static_cast<std::int64_t>(rows1_.step1()),
          rows1_.rows, blocks2_.ptr<std::int32_t>(), n2_,
          rows1_.cols};
}

void BlockDistances::to_blocks(int i, int first_block, int block_count, Key* keys) const {
  kernel_(rows1_.ptr<std::int32_t>(i), blocks2_.ptr<std::int32_t>(first_block * rows1_.cols), rows1_.cols,
          block_count, keys);
}

Neighbours exact_neighbours(const DescriptorPair& pair, bool both_ways, Instructions instructions) {
  const BlockDistances distances(pair, instructions);
  Neighbours neighbours;
  neighbours.of_set1.resize(pair.set1.rows);
  if (!both_ways) {
    find_nearest(distances.all_pairs(), instructions, neighbours.of_set1.data(), nullptr);
    return neighbours;
  }
  std::vector<Key> keys(pair.set2.rows, INT_MAX);
  neighbours.of_set2.resize(pair.set2.rows, -1);
  const NearestOfSecond nearest2{keys.data(), neighbours.of_set2.data()};
  find_nearest(distances.all_pairs(), instructions, neighbours.of_set1.data(), &nearest2);
  return neighbours;
}

}  // namespace framewise
