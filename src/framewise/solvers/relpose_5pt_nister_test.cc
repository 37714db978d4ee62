// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relpose_5pt_nister.h"

#include <gtest/gtest.h>

#include "framewise/solvers/five_point_laws_for_tests.h"

namespace framewise::testing {
namespace {

struct Relpose5ptNister {
  static constexpr std::size_t kPoints = 5;
  // The determinant of B(z) cancels to the square of the parallax, so with a baseline of 1e-4 of the depth
  // about one true solution in twenty is lost (Stewenius' elimination keeps it), and without any baseline
  // more.
  static Accuracy accuracy(Scene scene) {
    if (scene == Scene::kTinyBaseline || scene == Scene::kPureRotation) return {kNotHere, kNotHere};
    return five_point_accuracy(scene);
  }
  static auto solve(const TwoViewProblem& p) { return relpose_5pt_nister(five(p.x1), five(p.x2)); }
  static auto essential(const TwoViewProblem& p) { return essential_5pt_nister(five(p.x1), five(p.x2)); }
};

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(Nister, SolverLaws, Relpose5ptNister);
INSTANTIATE_TYPED_TEST_SUITE_P(Nister, FivePointLaws, Relpose5ptNister);

}  // namespace framewise::testing
