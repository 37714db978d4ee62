// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/ransac_iterations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace framewise {

double ransac_iterations(double confidence, double inlier_share, int sample_size) {
  const auto require = [](bool good, const char* name, double found, const char* expected) {
    if (good) return;
    throw std::invalid_argument("ransac_iterations: " + std::string(name) + " is " + std::to_string(found) +
                                ", expected " + expected);
  };
  require(confidence > 0 && confidence < 1, "confidence", confidence, "a probability between 0 and 1");
  require(inlier_share >= 0 && inlier_share <= 1, "inlier_share", inlier_share, "a share in [0, 1]");
  require(sample_size >= 1, "sample_size", sample_size, "at least 1");

  const double clean_sample = std::pow(inlier_share, sample_size);
  if (clean_sample <= 0) return std::numeric_limits<double>::infinity();
  if (clean_sample >= 1) return 1;
  return std::max(1.0, std::log1p(-confidence) / std::log1p(-clean_sample));
}

}  // namespace framewise
