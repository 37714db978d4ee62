// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relpose_5pt_stewenius.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framewise/solvers/five_point_laws_for_tests.h"
#include "framewise/solvers/relpose_5pt_nister.h"

namespace framewise::testing {
namespace {

struct Relpose5ptStewenius {
  static constexpr std::size_t kPoints = 5;
  static Accuracy accuracy(Scene scene) { return five_point_accuracy(scene); }
  static auto solve(const TwoViewProblem& p) { return relpose_5pt_stewenius(five(p.x1), five(p.x2)); }
  static auto essential(const TwoViewProblem& p) { return essential_5pt_stewenius(five(p.x1), five(p.x2)); }
};

// The QR iteration on the action matrix of these needs more than the usual 40 steps.
TEST(Stewenius, FindsWhatNisterFindsWhereTheEigenvaluesComeSlowly) {
  const std::array<Bearing, 5> x1{Bearing{-0.25318050354051153, 0.13501275717762257, 0.957951558287928},
                                  Bearing{0.22611236740736226, 0.30102211009365859, 0.92642262846942558},
                                  Bearing{-0.12637739002904341, 0.21977701078456227, 0.96732973738020145},
                                  Bearing{-0.42086617240590563, 0.31560218833359516, 0.85045101190100791},
                                  Bearing{-0.27046361977137967, 0.21973022326507585, 0.9373196143066902}};
  const std::array<Bearing, 5> x2{Bearing{-0.0097445996999722066, -0.3771521816277284, 0.92610003491530668},
                                  Bearing{0.41519634822109347, -0.22712963965321681, 0.88092231167956481},
                                  Bearing{0.10440251769094802, -0.29558322181129904, 0.94959500487494342},
                                  Bearing{-0.22807566810369892, -0.12499161797238698, 0.96558717113251669},
                                  Bearing{0.031111544202697839, -0.38746535230468532, 0.92135914418902332}};
  const auto matrices = essential_5pt_stewenius(x1, x2), others = essential_5pt_nister(x1, x2);
  ASSERT_EQ(matrices.size(), 4u);
  ASSERT_EQ(others.size(), 4u);
  for (const Eigen::Matrix3d& other : others) {
    double nearest = 10;
    for (const Eigen::Matrix3d& E : matrices)  // of any scale and sign
      nearest = std::min(nearest, 1 - std::abs(E.cwiseProduct(other).sum()) / (E.norm() * other.norm()));
    EXPECT_LT(nearest, 1e-12);
  }
}

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(Stewenius, SolverLaws, Relpose5ptStewenius);
INSTANTIATE_TYPED_TEST_SUITE_P(Stewenius, FivePointLaws, Relpose5ptStewenius);

}  // namespace framewise::testing
