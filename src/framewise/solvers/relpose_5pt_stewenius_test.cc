// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relpose_5pt_stewenius.h"

#include <gtest/gtest.h>

#include "framewise/solvers/five_point_laws_for_tests.h"

namespace framewise::testing {
namespace {

struct Relpose5ptStewenius {
  static constexpr std::size_t kPoints = 5;
  static Accuracy accuracy(Scene scene) { return five_point_accuracy(scene); }
  static auto solve(const TwoViewProblem& p) { return relpose_5pt_stewenius(five(p.x1), five(p.x2)); }
  static auto essential(const TwoViewProblem& p) { return essential_5pt_stewenius(five(p.x1), five(p.x2)); }
};

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(Stewenius, SolverLaws, Relpose5ptStewenius);
INSTANTIATE_TYPED_TEST_SUITE_P(Stewenius, FivePointLaws, Relpose5ptStewenius);

}  // namespace framewise::testing
