// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/ransac_options.h"

#include <stdexcept>
#include <string>

namespace framewise {

void RansacOptions::check() const {
  const auto require = [](bool good, const char* field, double found, const char* expected) {
    if (good) return;
    throw std::invalid_argument("RansacOptions." + std::string(field) + " is " + std::to_string(found) +
                                ", expected " + expected);
  };
  require(min_iterations >= 1, "min_iterations", min_iterations, "at least 1");
  require(max_iterations >= min_iterations, "max_iterations", max_iterations, "at least min_iterations");
  require(confidence > 0 && confidence < 1, "confidence", confidence, "a probability between 0 and 1");
}

}  // namespace framewise
