// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "framewise/robust/random_stream.h"

namespace framewise {

// Draws `sample.size()` different indices below `size`; size must not be smaller than the sample.
void draw_distinct(std::size_t size, std::span<std::uint32_t> sample, RandomStream& random);

// Samples for hypothesis after hypothesis, from correspondences that are sorted best first: begins with the
// best few and widens until it draws from all.
//   Chum and Matas, Matching with PROSAC - Progressive Sample Consensus, CVPR 2005.
class ProsacSampler {
 public:
  // After max_iterations samples PROSAC has become RANSAC (T_N of the paper).
  ProsacSampler(std::size_t size, std::size_t sample_size, int max_iterations);

  void draw(std::span<std::uint32_t> sample, RandomStream& random);

 private:
  std::size_t size_;
  std::size_t pool_;        // n: the samples come from the first n correspondences
  double mean_samples_;     // T_n of Eq. (3)
  double samples_at_pool_;  // T'_n of Eq. (4)
  double drawn_ = 0;        // t
};

}  // namespace framewise
