// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/bootstrap.h"

#include <gtest/gtest.h>

#include <limits>

#include "framewise/evaluation/series_for_tests.h"

namespace framewise {
namespace {

// Root of the mean square of the frames drawn.
FrameFigure rms_of(const std::vector<double>& series) {
  return [&series](std::span<const std::size_t> frames) {
    double sum = 0;
    for (const std::size_t i : frames) sum += series[i] * series[i];
    return std::sqrt(sum / static_cast<double>(frames.size()));
  };
}

// The share of recordings whose interval holds the true figure, which is 1.
double coverage(std::size_t n, double phi, const BootstrapOptions& options, std::uint64_t seed) {
  constexpr int kRecordings = 400;
  std::mt19937_64 random(seed);
  int covered = 0;
  for (int i = 0; i < kRecordings; ++i) {
    const std::vector<double> noise = ar1_noise(n, phi, random);
    std::vector<double> squares;
    for (const double x : noise) squares.push_back(x * x);
    const auto interval = bootstrap_interval(squares, rms_of(noise), options);
    covered += interval && interval->low <= 1 && 1 <= interval->high;
  }
  return static_cast<double>(covered) / kRecordings;
}

TEST(BootstrapInterval, CoversTheTruthNearlyAsOftenAsItSays) {
  BootstrapOptions options;
  options.resamples = 400;
  for (const double phi : {0.0, 0.3, 0.6}) {
    const double covered = coverage(150, phi, options, 1);
    EXPECT_GT(covered, 0.88) << "phi " << phi;
    EXPECT_LT(covered, 0.985) << "phi " << phi;
  }
  options.confidence = 0.7;
  EXPECT_NEAR(coverage(150, 0.3, options, 2), 0.7, 0.08);
}

TEST(BootstrapInterval, IsTooShortWhereFramesThatDependAreDrawnOneByOne) {
  BootstrapOptions options;
  options.resamples = 400;
  options.block_length = 1;
  EXPECT_LT(coverage(150, 0.8, options, 3), 0.80);
}

TEST(BootstrapInterval, RepeatsItselfBySeed) {
  std::mt19937_64 random(4);
  const std::vector<double> noise = ar1_noise(100, 0.5, random);
  BootstrapOptions options;
  const auto first = bootstrap_interval(noise, rms_of(noise), options);
  const auto second = bootstrap_interval(noise, rms_of(noise), options);
  options.seed = 1;
  const auto other = bootstrap_interval(noise, rms_of(noise), options);
  ASSERT_TRUE(first && second && other);
  EXPECT_EQ(first->low, second->low);
  EXPECT_EQ(first->high, second->high);
  EXPECT_NE(first->low, other->low);
}

TEST(BootstrapInterval, OfErrorsThatAreAllEqualHasNoLength) {
  const std::vector<double> series(50, 2.0);
  const auto interval = bootstrap_interval(series, rms_of(series));
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 2);
  EXPECT_EQ(interval->high, 2);
}

TEST(BootstrapInterval, DrawsNoFrameThatIsNotThere) {
  const std::vector<double> series(7, 1.0);
  BootstrapOptions options;
  options.block_length = 100;
  bootstrap_interval(
      series,
      [&](std::span<const std::size_t> frames) {
        EXPECT_EQ(frames.size(), series.size());
        for (const std::size_t i : frames) EXPECT_LT(i, series.size());
        return 0.0;
      },
      options);
}

TEST(BootstrapInterval, NeedsSixFramesAndFiniteErrors) {
  std::vector<double> series(5, 1.0);
  EXPECT_FALSE(bootstrap_interval(series, rms_of(series)));
  EXPECT_FALSE(bootstrap_interval({}, rms_of(series)));
  series.assign(6, 1.0);
  EXPECT_TRUE(bootstrap_interval(series, rms_of(series)));
  series[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(bootstrap_interval(series, rms_of(series)), std::invalid_argument);
}

TEST(BootstrapInterval, RefusesOptionsThatMakeNone) {
  const std::vector<double> series(10, 1.0);
  BootstrapOptions options;
  options.confidence = 1;
  EXPECT_THROW(bootstrap_interval(series, rms_of(series), options), std::invalid_argument);
  options = {};
  options.resamples = 0;
  EXPECT_THROW(bootstrap_interval(series, rms_of(series), options), std::invalid_argument);
}

TEST(DependenceLength, GrowsWithMemory) {
  std::mt19937_64 random(5);
  const auto mean_length = [&](double phi) {
    double sum = 0;
    for (int i = 0; i < 50; ++i) sum += static_cast<double>(dependence_length(ar1_noise(400, phi, random)));
    return sum / 50;
  };
  const double none = mean_length(0), some = mean_length(0.5), much = mean_length(0.9);
  EXPECT_LT(none, 3);
  EXPECT_GT(some, 2 * none);
  EXPECT_GT(much, 2 * some);
}

TEST(DependenceLength, OfShortAndConstantSeriesIsOne) {
  EXPECT_EQ(dependence_length({}), 1u);
  EXPECT_EQ(dependence_length(std::vector<double>(5, 1.0)), 1u);
  EXPECT_EQ(dependence_length(std::vector<double>(100, 1.0)), 1u);
}

}  // namespace
}  // namespace framewise
