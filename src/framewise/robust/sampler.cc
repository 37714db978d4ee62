// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/sampler.h"

#include <algorithm>
#include <cmath>

namespace framewise {

void draw_distinct(std::size_t size, std::span<std::uint32_t> sample, RandomStream& random) {
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const auto drawn = sample.first(i);
    do {
      sample[i] = random.index(size);
    } while (std::find(drawn.begin(), drawn.end(), sample[i]) != drawn.end());
  }
}

ProsacSampler::ProsacSampler(std::size_t size, std::size_t sample_size, int max_iterations)
    : size_(size), pool_(sample_size), mean_samples_(max_iterations), samples_at_pool_(1) {
  for (std::size_t i = 0; i < sample_size; ++i) {
    mean_samples_ *= static_cast<double>(sample_size - i) / static_cast<double>(size - i);
  }
}

void ProsacSampler::draw(std::span<std::uint32_t> sample, RandomStream& random) {
  ++drawn_;
  while (drawn_ > samples_at_pool_ && pool_ < size_) {
    const double n = static_cast<double>(pool_);
    const double wider = mean_samples_ * (n + 1) / (n + 1 - static_cast<double>(sample.size()));  // Eq. (3)
    samples_at_pool_ += std::ceil(wider - mean_samples_);                                         // Eq. (4)
    mean_samples_ = wider;
    ++pool_;
  }
  if (pool_ == size_ && drawn_ > samples_at_pool_) return draw_distinct(size_, sample, random);
  // The newest member of the pool is in every sample, so that no sample is drawn at two pool sizes.
  draw_distinct(pool_ - 1, sample.first(sample.size() - 1), random);
  sample.back() = static_cast<std::uint32_t>(pool_ - 1);
}

}  // namespace framewise
