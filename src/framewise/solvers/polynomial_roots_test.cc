// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/polynomial_roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::Random;

TEST(CubicRoots, LargestOfThreeIsFound) {
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const double a = random.uniform(-3, 3), b = random.uniform(-3, 3), c = random.uniform(-3, 3);
    const double largest = largest_cubic_root(-(a + b + c), a * b + b * c + c * a, -a * b * c);
    EXPECT_NEAR(largest, std::max({a, b, c}), 1e-6);
    const double outer = outermost_cubic_root(-(a + b + c), a * b + b * c + c * a, -a * b * c);
    EXPECT_LT(std::min({std::abs(outer - a), std::abs(outer - b), std::abs(outer - c)}), 1e-6);
  }
}

TEST(CubicRoots, TheOnlyRealOneIsFound) {
  Random random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const double a = random.uniform(-3, 3), re = random.uniform(-3, 3), im = random.uniform(0.1, 3);
    const double norm = re * re + im * im;  // (s - a)(s^2 - 2 re s + norm)
    EXPECT_NEAR(largest_cubic_root(-a - 2 * re, norm + 2 * a * re, -a * norm), a, 1e-9);
    EXPECT_NEAR(outermost_cubic_root(-a - 2 * re, norm + 2 * a * re, -a * norm), a, 1e-9);
  }
}

void expect_roots(std::vector<double> truth, const Hypotheses<double, 4>& roots, double tolerance) {
  std::vector<double> found(roots.begin(), roots.end());
  ASSERT_EQ(found.size(), truth.size());
  std::sort(truth.begin(), truth.end());
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(found[i], truth[i], tolerance);
}

TEST(QuarticRoots, FourTwoAndNone) {
  Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    // (y^2 - s1 y + p1)(y^2 - s2 y + p2)
    const auto roots = [](double s1, double p1, double s2, double p2) {
      return quartic_roots(-s1 - s2, p1 + p2 + s1 * s2, -s1 * p2 - s2 * p1, p1 * p2);
    };
    const double a = random.uniform(-3, -2), b = random.uniform(-1, 0), c = random.uniform(1, 2),
                 d = random.uniform(3, 4);
    expect_roots({a, b, c, d}, roots(a + c, a * c, b + d, b * d), 1e-9);
    const double re = random.uniform(-2, 2), im = random.uniform(0.5, 2), norm = re * re + im * im;
    expect_roots({a, b}, roots(a + b, a * b, 2 * re, norm), 1e-9);
    expect_roots({}, roots(2 * re, norm, 2 * c, c * c + d * d), 1e-9);
  }
}

TEST(QuarticRoots, EvenQuartics) {
  expect_roots({-2, -1, 1, 2}, quartic_roots(0, -5, 0, 4), 1e-12);
  expect_roots({-1, 1}, quartic_roots(0, 0, 0, -1), 1e-12);
  expect_roots({}, quartic_roots(0, 0, 0, 1), 1e-12);
  expect_roots({0, 0, 0, 0}, quartic_roots(0, 0, 0, 0), 1e-12);
}

}  // namespace
}  // namespace framewise
