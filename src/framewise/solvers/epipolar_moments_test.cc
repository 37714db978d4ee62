// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/epipolar_moments.h"

#include <gtest/gtest.h>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::Scene;

TEST(EpipolarMoments, GiveTheEigenvaluesOfTheSumOverPoints) {
  Random random(1);
  const auto p = make_problem(Scene::kRandom, 12, random);
  std::vector<double> weights;
  for (int i = 0; i < 12; ++i) weights.push_back(random.uniform(0.1, 2));
  const EpipolarMoments moments(p.x1, p.x2, weights);
  const Eigen::Matrix3d R = so3_exp(random.direction());
  const auto value = moments.evaluate(R);
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d n = p.x2[i].cross(R * p.x1[i]);
    M += weights[i] * n * n.transpose();
  }
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d v = value.eigenvectors.col(k);
    EXPECT_LT((M * v - value.eigenvalues[k] * v).norm(), 1e-12 * M.norm());
  }
  EXPECT_LE(value.eigenvalues[0], value.eigenvalues[1]);
  EXPECT_LE(value.eigenvalues[1], value.eigenvalues[2]);
}

TEST(EpipolarMoments, DerivativesAreTheNumericOnes) {
  Random random(2);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry, Scene::kForward})
    for (int trial = 0; trial < 20; ++trial) {
      const auto p = make_problem(scene, 10, random);
      const EpipolarMoments moments(p.x1, p.x2, {});
      const Eigen::Matrix3d R = so3_exp(0.3 * random.direction()) * p.cam2_from_cam1.R;
      const auto analytic = moments.derivatives(R, moments.evaluate(R));
      const auto cost = [&](const Eigen::Vector3d& w) {
        return moments.evaluate(so3_exp(w) * R).eigenvalues[0];
      };
      const double h = 1e-4;
      for (int a = 0; a < 3; ++a) {
        const Eigen::Vector3d ha = h * Eigen::Vector3d::Unit(a);
        EXPECT_NEAR(analytic.gradient[a], (cost(ha) - cost(-ha)) / (2 * h), 1e-5);
        for (int b = 0; b < 3; ++b) {
          const Eigen::Vector3d hb = h * Eigen::Vector3d::Unit(b);
          const double second =
              (cost(ha + hb) - cost(ha - hb) - cost(hb - ha) + cost(-ha - hb)) / (4 * h * h);
          EXPECT_NEAR(analytic.hessian(a, b), second, 2e-3 * (0.1 + std::abs(second)));
        }
      }
    }
}

TEST(EpipolarMoments, LinearSolutionOfExactDataIsTheEssentialMatrix) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto p = make_problem(Scene::kRandom, 20, random);
    double residual = 1;
    const Eigen::Matrix3d found = EpipolarMoments(p.x1, p.x2, {}).linear_solution(residual);
    const Eigen::Matrix3d E = skew(p.cam2_from_cam1.t.normalized()) * p.cam2_from_cam1.R / std::sqrt(2.0);
    EXPECT_LT(std::min((found - E).norm(), (found + E).norm()), 1e-6);
    EXPECT_LT(residual, 1e-13);
  }
}

}  // namespace
}  // namespace framewise
