// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_registration.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/geometry/alignment.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/solvers/refinement_for_tests.h"

namespace framewise {
namespace {

using testing::Random;
using testing::Scene;

struct Clouds {
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<Eigen::Matrix3d> S1, S2;
};

Eigen::Vector3d drawn(const Eigen::Vector3d& X, const Eigen::Matrix3d& S, Random& random) {
  return X + S.llt().matrixL() * random.normal3();
}

// Points with the noise of a depth camera, `level` times.
Clouds noisy_clouds(const testing::TwoViewProblem& p, double level, Random& random) {
  Clouds c;
  const DepthNoise noise;
  for (std::size_t i = 0; i < p.X1.size(); ++i) {
    const double z1 = p.X1[i].z(), z2 = p.X2[i].z();
    c.S1.push_back(level * level * point_covariance(p.X1[i], z1, 1e-3, noise.sigma(z1)));
    c.S2.push_back(level * level * point_covariance(p.X2[i], z2, 1e-3, noise.sigma(z2)));
    c.X1.push_back(drawn(p.X1[i], c.S1.back(), random));
    c.X2.push_back(drawn(p.X2[i], c.S2.back(), random));
  }
  return c;
}

TEST(RefineRegistration, ExactDataLeadBackToTheTruth) {
  Random random(1);
  for (const Scene scene : testing::kAllScenes) {
    const auto p = testing::make_problem(scene, 20, random);
    const Clouds c = noisy_clouds(p, 1, random);
    const auto found =
        refine_registration(testing::perturbed(p.cam2_from_cam1, 0.1, 0.3, random), p.X1, c.S1, p.X2, c.S2);
    EXPECT_TRUE(found.converged);
    EXPECT_LT(testing::rigid_error(found.pose, p.cam2_from_cam1).norm(), 1e-6) << name(scene);
  }
}

TEST(RefineRegistration, CovarianceIsConsistentAndTheEstimateUnbiased) {
  for (const double level : {1.0, 3.0})
    for (const Scene scene : {Scene::kRandom, Scene::kOdometry}) {
      Random random(2);
      testing::Consistency consistency;
      int stuck = 0;
      for (int trial = 0; trial < 1000; ++trial) {
        const auto p = testing::make_problem(scene, 50, random);
        const Clouds c = noisy_clouds(p, level, random);
        const auto found = refine_registration(*kabsch(c.X1, c.X2), c.X1, c.S1, c.X2, c.S2);
        stuck += !found.converged;
        consistency.add(testing::rigid_error(found.pose, p.cam2_from_cam1), found.covariance);
      }
      EXPECT_LE(stuck, 2);  // flat valleys, where the steps left are far below a sigma
      EXPECT_NEAR(consistency.nees(), 1, 0.1) << "level " << level;
      EXPECT_LT(consistency.bias(), 4) << "level " << level;
    }
}

TEST(RefineRegistration, EqualRoundCovariancesGiveKabsch) {
  Random random(3);
  const auto p = testing::make_problem(Scene::kRandom, 20, random);
  const Clouds c = noisy_clouds(p, 1, random);
  const std::vector<Eigen::Matrix3d> S(20, 0.01 * Eigen::Matrix3d::Identity());
  const Pose expected = *kabsch(c.X1, c.X2);
  const auto found = refine_registration(p.cam2_from_cam1, c.X1, S, c.X2, S);
  EXPECT_LT(testing::rigid_error(found.pose, expected).norm(), 1e-6);
}

TEST(RefineRegistration, WeighingByCovarianceBeatsKabsch) {
  Random random(4);
  double weighed = 0, plain = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto p = testing::make_problem(Scene::kOdometry, 100, random);
    const Clouds c = noisy_clouds(p, 1, random);
    const Pose initial = *kabsch(c.X1, c.X2);
    plain += (initial.t - p.cam2_from_cam1.t).norm();
    weighed += (refine_registration(initial, c.X1, c.S1, c.X2, c.S2).pose.t - p.cam2_from_cam1.t).norm();
  }
  EXPECT_LT(weighed, 0.5 * plain);
}

TEST(RefineRegistration, WrongUseThrows) {
  std::vector<Eigen::Vector3d> X(4, Eigen::Vector3d(0, 0, 1));
  std::vector<Eigen::Matrix3d> S(4, Eigen::Matrix3d::Identity()), three(3), flat(4, Eigen::Matrix3d::Zero()),
      bent = S;
  bent[2](0, 1) = 0.5;
  EXPECT_THROW(refine_registration(Pose{}, X, three, X, S), std::invalid_argument);
  EXPECT_THROW(refine_registration(Pose{}, X, flat, X, flat), std::invalid_argument);
  EXPECT_THROW(refine_registration(Pose{}, X, S, X, bent), std::invalid_argument);
  EXPECT_NO_THROW(refine_registration(Pose{}, X, S, X, flat));
  X[1].x() = NAN;
  EXPECT_THROW(refine_registration(Pose{}, X, S, X, S), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
