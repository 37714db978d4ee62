// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace framewise {

struct BootstrapOptions {
  double confidence = 0.95;      // that the interval covers the true value
  int resamples = 2000;          // the ends of a 95 % interval then repeat to a twentieth of its length
  std::size_t block_length = 0;  // frames; 0: chosen from the series
  std::uint64_t seed = 0;
  void check() const;  // throws std::invalid_argument naming the value
};

struct Interval {
  double low = 0;
  double high = 0;
};

// A figure of the frames with these indices; a frame may be there several times.
using FrameFigure = std::function<double(std::span<const std::size_t> frames)>;

// How many successive frames belong together when the mean of a series is bootstrapped: 1 where they do not
// depend on each other, more the longer they remember.
//   Politis and White, Automatic Block-Length Selection for the Dependent Bootstrap, Econometric Reviews
//   2004, with the correction of Patton, Politis, White, 2009 (their b_CB, rounded; at least 1, at most the
//   smaller of n / 3 and 3 sqrt(n)).
std::size_t dependence_length(std::span<const double> series);

// Where the figure of all frames would lie on another recording of the same kind: moving-block bootstrap,
// since the errors of neighbouring frames depend on each other.
//   Kuensch, The Jackknife and the Bootstrap for General Stationary Observations, Annals of Statistics 1989.
// The interval is the percentile interval, expanded by Student's t for the number of blocks, without which
// it is too short for a hundred frames (Hesterberg, What Teachers Should Know About the Bootstrap, The
// American Statistician 2015, section 4.3). `series` is what the frames contribute to the figure: its length
// is their number, and blocks are as long as it remembers but not shorter than n^(1/3) (Hall, Horowitz, Jing,
// On blocking rules for the bootstrap with dependent data, Biometrika 1995). Empty where there are fewer than
// 6 frames. Throws std::invalid_argument for a series that is not finite.
std::optional<Interval> bootstrap_interval(std::span<const double> series, const FrameFigure& figure,
                                           const BootstrapOptions& options = {});

}  // namespace framewise
