// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace framewise {

// Noise of unit variance in which a value remembers the share phi of the one before: AR(1).
inline std::vector<double> ar1_noise(std::size_t n, double phi, std::mt19937_64& random) {
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] {  // Box and Muller 1958
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  };
  std::vector<double> noise(n);
  double last = normal();
  for (double& value : noise) value = last = phi * last + std::sqrt(1 - phi * phi) * normal();
  return noise;
}

}  // namespace framewise
