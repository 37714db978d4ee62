// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace framewise {

// The price of a correspondence with residual r against the threshold T; the lower the sum, the better.
enum class Scoring {
  kInlierCount,  // 0 inside, 1 outside: Fischler and Bolles, CACM 1981
  kMsac,         // min(r^2 / T^2, 1): Torr and Zisserman, MLESAC, CVIU 2000
  kMarginalised  // noise level unknown up to T, integrated out: after Barath et al., MAGSAC++, CVPR 2020
};

enum class Sampling {
  kUniform,
  kProsac  // correspondences are given best first: Chum and Matas, CVPR 2005
};

struct RansacOptions {
  std::uint64_t seed = 0;      // of every random choice
  int min_iterations = 20;     // hypotheses tried however good the first are
  int max_iterations = 10000;  // and never more than this
  double confidence = 0.99;    // stop when a sample without outliers was drawn with this probability
  Scoring scoring = Scoring::kMsac;
  Sampling sampling = Sampling::kUniform;
  bool local_optimisation = true;  // least squares on the inliers of every best hypothesis so far
  bool early_bailout = true;       // drop a hypothesis when its first points say that it is hopeless

  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

}  // namespace framewise
