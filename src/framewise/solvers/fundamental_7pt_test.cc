// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/fundamental_7pt.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "framewise/solvers/solver_laws_for_tests.h"

namespace framewise::testing {
namespace {

std::array<Bearing, 7> seven(const std::vector<Bearing>& x) {
  std::array<Bearing, 7> result;
  std::copy_n(x.begin(), 7, result.begin());
  return result;
}

TEST(Fundamental7pt, SolutionsSolveTheEquationsAndAreSingular) {
  Random random(1);
  for (const Scene scene : kAllScenes) {
    for (int trial = 0; trial < 100; ++trial) {
      const TwoViewProblem p = make_problem(scene, 7, random);
      const auto solutions = fundamental_7pt(seven(p.x1), seven(p.x2));
      if (scene == Scene::kRandom) {
        EXPECT_EQ(solutions.size() % 2, 1u);
      }
      for (const Eigen::Matrix3d& F : solutions) {
        EXPECT_NEAR(F.norm(), 1, 1e-14);
        EXPECT_LT(std::abs(F.determinant()), 1e-10);
        for (int i = 0; i < 7; ++i) EXPECT_LT(std::abs(p.x2[i].dot(F * p.x1[i])), 1e-14);
      }
    }
  }
}

TEST(Fundamental7pt, FindsTheMatrixOfUncalibratedCameras) {
  Random random(2);
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const TwoViewProblem p = make_problem(Scene::kRandom, 7, random);
    Eigen::Matrix3d K;
    K << 0.8, 0.01, 0.1, 0, 1.1, -0.05, 0, 0, 1;
    auto u1 = seven(p.x1), u2 = seven(p.x2);
    for (Eigen::Vector3d& u : u1) u = (K * u / u.z()).eval();
    const Eigen::Matrix3d F = (skew(p.cam2_from_cam1.t) * p.cam2_from_cam1.R * K.inverse()).normalized();
    const auto solutions = fundamental_7pt(u1, u2);
    found += std::any_of(solutions.begin(), solutions.end(), [&](const Eigen::Matrix3d& solution) {
      return std::min((solution - F).norm(), (solution + F).norm()) < 1e-6;
    });
  }
  EXPECT_GE(found, 198);
}

struct Relpose7pt {
  static constexpr std::size_t kPoints = 7;
  // Seven points of a plane satisfy F = [e]x H for every e, and so does everything [t]x R without
  // translation: in both the space of solutions is larger than the two dimensions the solver searches. With a
  // baseline of 1e-4 of the depth the equations' third smallest singular value is 1e-4 of the largest, and
  // the roots meet.
  static Accuracy accuracy(Scene scene) {
    if (scene == Scene::kPlanar || scene == Scene::kPureRotation) return {kNotHere, kNotHere};
    if (scene == Scene::kTinyBaseline) return {1e-5, 0.1};
    return {1e-6, 1e-4};
  }
  static auto solve(const TwoViewProblem& p) { return relpose_7pt(seven(p.x1), seven(p.x2)); }
};

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(SevenPoint, SolverLaws, Relpose7pt);

}  // namespace framewise::testing
