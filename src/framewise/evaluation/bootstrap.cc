// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "framewise/evaluation/spread.h"

namespace framewise {
namespace {

constexpr std::size_t kMinFrames = 6, kMinBlocks = 3;

void check_finite(std::span<const double> series) {
  for (std::size_t i = 0; i < series.size(); ++i)
    if (!std::isfinite(series[i]))
      throw std::invalid_argument("series[" + std::to_string(i) + "] is " + std::to_string(series[i]) +
                                  ", expected a finite number");
}

// R(k) = sum over i of (x_i - mean)(x_{i+k} - mean) / n, k = 0 ... max_lag.
std::vector<double> autocovariances(std::span<const double> x, std::size_t max_lag) {
  const double n = static_cast<double>(x.size()), mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  std::vector<double> R(max_lag + 1);
  for (std::size_t k = 0; k <= max_lag; ++k)
    for (std::size_t i = 0; i + k < x.size(); ++i) R[k] += (x[i] - mean) * (x[i + k] - mean) / n;
  return R;
}

// The smallest lag after which `run` correlations in a row are no more than chance makes them; where there is
// none, the last lag that is more.
std::size_t last_correlated_lag(const std::vector<double>& R, std::size_t n, std::size_t run) {
  const double by_chance = 2 * std::sqrt(std::log10(static_cast<double>(n)) / static_cast<double>(n)) * R[0];
  const auto is_chance = [&](double r) { return std::abs(r) < by_chance; };
  for (std::size_t lag = 0; lag + run < R.size(); ++lag)
    if (std::all_of(R.begin() + lag + 1, R.begin() + lag + 1 + run, is_chance)) return lag;
  std::size_t last = 0;
  for (std::size_t lag = 1; lag < R.size(); ++lag)
    if (!is_chance(R[lag])) last = lag;
  return last;
}

double normal_quantile(double p) {
  double low = -40, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.5.
double student_quantile(double p, double degrees) {
  const double z = normal_quantile(p), z2 = z * z;
  return z + z * (z2 + 1) / (4 * degrees) + z * ((5 * z2 + 16) * z2 + 3) / (96 * degrees * degrees) +
         z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * std::pow(degrees, 3));
}

// The share of resamples to cut off at either end.
double expanded_tail(double confidence, double blocks) {
  const double t = student_quantile(0.5 * (1 + confidence), blocks - 1);
  return 0.5 * std::erfc(t * std::sqrt(blocks / (blocks - 1)) / std::sqrt(2.0));
}

std::size_t block_length(std::span<const double> series, const BootstrapOptions& options) {
  const std::size_t n = series.size(), longest = n / kMinBlocks;
  if (options.block_length > 0) return std::min(options.block_length, longest);
  const auto rule = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(n))));
  return std::clamp(std::max(rule, dependence_length(series)), std::size_t{1}, longest);
}

// Frames of blocks drawn at random until there are as many as in the series.
class BlockSampler {
 public:
  BlockSampler(std::size_t num_frames, std::size_t length, std::uint64_t seed)
      : random_(seed), length_(length), starts_(num_frames - length + 1), frames_(num_frames) {}

  std::span<const std::size_t> draw() {
    for (std::size_t i = 0; i < frames_.size();) {
      const std::size_t start = index(starts_), end = std::min(i + length_, frames_.size());
      for (std::size_t frame = start; i < end; ++i, ++frame) frames_[i] = frame;
    }
    return frames_;
  }

 private:
  // Uniform in [0, size) to size / 2^32, the same on every platform, which std:: distributions are not.
  std::size_t index(std::size_t size) { return ((random_() >> 32) * size) >> 32; }

  std::mt19937_64 random_;
  std::size_t length_, starts_;
  std::vector<std::size_t> frames_;
};

}  // namespace

void BootstrapOptions::check() const {
  if (!(confidence > 0 && confidence < 1))
    throw std::invalid_argument("confidence is " + std::to_string(confidence) + ", expected between 0 and 1");
  if (resamples < 100)
    throw std::invalid_argument("resamples is " + std::to_string(resamples) + ", expected 100 or more");
}

std::size_t dependence_length(std::span<const double> series) {
  check_finite(series);
  const std::size_t n = series.size();
  if (n < kMinFrames) return 1;
  const double root = std::sqrt(static_cast<double>(n));
  const auto run = std::max<std::size_t>(5, static_cast<std::size_t>(std::ceil(std::sqrt(std::log10(n)))));
  const std::size_t max_lag = std::min(static_cast<std::size_t>(std::ceil(root)) + run, n - 1);
  const std::vector<double> R = autocovariances(series, max_lag);
  if (R[0] <= 0) return 1;

  const std::size_t M = std::clamp<std::size_t>(2 * last_correlated_lag(R, n, run), 1, max_lag);
  double G = 0, g = R[0];  // sums over all lags of |k| R(k) and R(k) under a flat-top window
  for (std::size_t k = 1; k <= M; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(M);
    const double window = share <= 0.5 ? 1 : 2 * (1 - share);
    G += 2 * window * static_cast<double>(k) * R[k];
    g += 2 * window * R[k];
  }
  if (!(g * g > 0)) return 1;
  const double b = std::cbrt(2 * G * G / (4.0 / 3 * g * g) * static_cast<double>(n));
  return static_cast<std::size_t>(
      std::clamp(std::round(b), 1.0, std::floor(std::min(static_cast<double>(n) / 3, 3 * root))));
}

std::optional<Interval> bootstrap_interval(std::span<const double> series, const FrameFigure& figure,
                                           const BootstrapOptions& options) {
  options.check();
  check_finite(series);
  const std::size_t n = series.size();
  if (n < kMinFrames) return std::nullopt;
  const std::size_t length = block_length(series, options);
  BlockSampler sampler(n, length, options.seed);
  std::vector<double> figures(static_cast<std::size_t>(options.resamples));
  for (double& value : figures) value = figure(sampler.draw());
  const double tail = expanded_tail(options.confidence, static_cast<double>(n) / static_cast<double>(length));
  return Interval{quantile(figures, tail), quantile(figures, 1 - tail)};
}

}  // namespace framewise
