// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refinement.h"

#include <stdexcept>
#include <string>

namespace framewise {
namespace {

void check_field(bool valid, const char* name, double value, const char* expected) {
  if (!valid)
    throw std::invalid_argument(std::string("RefineOptions::") + name + " is " + std::to_string(value) +
                                ", expected " + expected);
}

}  // namespace

void RefineOptions::check() const {
  check_field(sigma > 1e-12 && sigma < 1, "sigma", sigma, "a noise between 1e-12 and 1 focal length");
  check_field(loss.threshold > 0 && loss.threshold < 1e6, "loss.threshold", loss.threshold,
              "a positive number of sigmas");
  check_field(max_iterations > 0, "max_iterations", max_iterations, "1 or more");
  check_field(tolerance > 0, "tolerance", tolerance, "a positive number");
}

}  // namespace framewise
