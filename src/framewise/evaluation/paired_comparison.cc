// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/paired_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

#include "framewise/evaluation/statistics.h"

namespace framewise {
namespace {

// With fewer no difference could be told from chance once p is corrected for fifty comparisons: all flips of
// twelve signs are 4096.
constexpr std::size_t kFewestBlocks = 12;

// Differences of a block that are at least m, and at most -m: as they are, and flipped (the other way round).
struct BlockCounts {
  std::size_t above = 0, below = 0;
};

std::vector<BlockCounts> count_blocks(std::span<const double> differences, std::size_t length, double m) {
  std::vector<BlockCounts> blocks((differences.size() + length - 1) / length);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    blocks[i / length].above += differences[i] >= m;
    blocks[i / length].below += differences[i] <= -m;
  }
  return blocks;
}

// The median is at least m away from 0 where half of the differences are.
class Flips {
 public:
  Flips(std::vector<BlockCounts> blocks, std::size_t num_differences)
      : blocks_(std::move(blocks)), half_((num_differences + 1) / 2) {}

  std::size_t num_blocks() const { return blocks_.size(); }

  // flipped(b): whether block b is.
  template <typename Flipped>
  bool as_far(Flipped&& flipped) const {
    BlockCounts sum;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const bool flip = flipped(b);
      sum.above += flip ? blocks_[b].below : blocks_[b].above;
      sum.below += flip ? blocks_[b].above : blocks_[b].below;
    }
    return sum.above >= half_ || sum.below >= half_;
  }

 private:
  std::vector<BlockCounts> blocks_;
  std::size_t half_;
};

// All flips, the observed signs among them.
double exact_p(const Flips& flips) {
  const std::uint64_t all = std::uint64_t{1} << flips.num_blocks();
  std::uint64_t as_far = 0;
  for (std::uint64_t signs = 0; signs < all; ++signs)
    as_far += flips.as_far([&](std::size_t block) { return (signs >> block) & 1; });
  return static_cast<double>(as_far) / static_cast<double>(all);
}

double sampled_p(const Flips& flips, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  int as_far = 1;
  for (int i = 0; i < count; ++i) {
    std::uint64_t signs = 0;
    as_far += flips.as_far([&](std::size_t block) {
      if (block % 64 == 0) signs = random();
      return (signs >> (block % 64)) & 1;
    });
  }
  return static_cast<double>(as_far) / (count + 1);
}

double flip_p(std::span<const double> differences, std::size_t length, const PairedOptions& options) {
  const Flips flips(count_blocks(differences, length, std::abs(median(differences))), differences.size());
  const bool few = flips.num_blocks() < 63 &&
                   (std::uint64_t{1} << flips.num_blocks()) <= static_cast<std::uint64_t>(options.flips);
  return few ? exact_p(flips) : sampled_p(flips, options.flips, options.bootstrap.seed);
}

}  // namespace

void PairedOptions::check() const {
  bootstrap.check();
  if (flips < 99) throw std::invalid_argument("flips is " + std::to_string(flips) + ", expected 99 or more");
  if (!(significance > 0 && significance < 1))
    throw std::invalid_argument("significance is " + std::to_string(significance) +
                                ", expected between 0 and 1");
}

PairedDifference paired_difference(std::span<const double> differences, const PairedOptions& options) {
  options.check();
  if (differences.empty())
    throw std::invalid_argument("paired_difference: differences is empty, expected one or more");
  PairedDifference result;
  result.frames = differences.size();
  const std::size_t memory = dependence_length(differences);  // refuses what is not finite
  result.median = median(differences);
  std::vector<double> drawn(differences.size());
  result.interval = bootstrap_interval(
      differences,
      [&](std::span<const std::size_t> frames) {
        std::transform(frames.begin(), frames.end(), drawn.begin(),
                       [&](std::size_t i) { return differences[i]; });
        return median(drawn);
      },
      options.bootstrap);
  result.block_length =
      std::clamp(2 * memory, std::size_t{1}, std::max(differences.size() / kFewestBlocks, std::size_t{1}));
  result.p = flip_p(differences, result.block_length, options);
  result.p_holm = result.p;
  result.is_real = result.p_holm < options.significance;
  return result;
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> corrected(p.size());
  double largest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, static_cast<double>(p.size() - rank) * p[order[rank]]);
    corrected[order[rank]] = std::min(1.0, largest);
  }
  return corrected;
}

BestComparison compare_with_best(std::span<const std::vector<double>> errors, std::span<const double> scores,
                                 const PairedOptions& options) {
  options.check();
  if (errors.empty() || errors.size() != scores.size())
    throw std::invalid_argument("compare_with_best: " + std::to_string(errors.size()) + " methods and " +
                                std::to_string(scores.size()) + " scores, expected as many, one or more");
  BestComparison result;
  result.best = static_cast<std::size_t>(std::min_element(scores.begin(), scores.end()) - scores.begin());
  result.differences.resize(errors.size());

  const std::vector<double>& best = errors[result.best];
  std::vector<double> p;
  for (std::size_t m = 0; m < errors.size(); ++m) {
    if (errors[m].size() != best.size())
      throw std::invalid_argument("compare_with_best: method " + std::to_string(m) + " has " +
                                  std::to_string(errors[m].size()) + " frames, expected " +
                                  std::to_string(best.size()) + " as the best has");
    if (m == result.best) continue;
    std::vector<double> differences(best.size());
    std::transform(errors[m].begin(), errors[m].end(), best.begin(), differences.begin(), std::minus<>());
    result.differences[m] = paired_difference(differences, options);
    p.push_back(result.differences[m]->p);
  }

  const std::vector<double> corrected = holm(p);
  auto next = corrected.begin();
  for (auto& difference : result.differences) {
    if (!difference) continue;
    difference->p_holm = *next++;
    difference->is_real = difference->p_holm < options.significance;
  }
  return result;
}

}  // namespace framewise
