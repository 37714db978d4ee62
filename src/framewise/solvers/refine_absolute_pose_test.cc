// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_absolute_pose.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/solvers/refinement_for_tests.h"

namespace framewise {
namespace {

using testing::Random;
using testing::Scene;

TEST(RefineAbsolutePose, ExactDataLeadBackToTheTruth) {
  Random random(1);
  for (const Scene scene : testing::kAllScenes)
    for (const ImageSurface surface : testing::kSurfaces)
      for (const std::size_t size : {4, 50}) {
        const auto p = testing::make_problem(scene, size, random);
        RefineOptions options;
        options.surface = surface;
        const auto found = refine_absolute_pose(testing::perturbed(p.cam2_from_cam1, 0.01, 0.02, random),
                                                p.X1, p.x2, options);
        EXPECT_TRUE(found.converged);
        EXPECT_LT(testing::rigid_error(found.pose, p.cam2_from_cam1).norm(), 1e-7) << name(scene);
      }
}

TEST(RefineAbsolutePose, CovarianceIsConsistentAndTheEstimateUnbiased) {
  for (const double sigma : {0.5 / 525, 2.0 / 525})
    for (const ImageSurface surface : testing::kSurfaces) {
      const Scene scene = surface == ImageSurface::kPlane ? Scene::kOdometry : Scene::kRandom;
      Random random(2);
      testing::Consistency consistency;
      int stuck = 0;
      for (int trial = 0; trial < 1000; ++trial) {
        const auto p = testing::make_problem(scene, 50, random);
        RefineOptions options;
        options.sigma = sigma;
        options.surface = surface;
        const auto x2 = testing::noisy_rays(p.x2, surface, sigma, random);
        const auto found =
            refine_absolute_pose(testing::perturbed(p.cam2_from_cam1, 0.01, 0.02, random), p.X1, x2, options);
        stuck += !found.converged;
        consistency.add(testing::rigid_error(found.pose, p.cam2_from_cam1), found.covariance);
      }
      EXPECT_LE(stuck, 2);  // flat valleys, where the steps left are far below a sigma
      EXPECT_NEAR(consistency.nees(), 1, 0.1) << "sigma " << sigma;
      EXPECT_LT(consistency.bias(), 4) << "sigma " << sigma;
    }
}

TEST(RefineAbsolutePose, ConvergesFromAfar) {
  Random random(3);
  int reached = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = testing::make_problem(Scene::kRandom, 30, random);
    const auto found =
        refine_absolute_pose(testing::perturbed(p.cam2_from_cam1, 0.3, 0.5, random), p.X1, p.x2);
    reached += testing::rigid_error(found.pose, p.cam2_from_cam1).norm() < 1e-6;
  }
  EXPECT_GE(reached, 195);
}

TEST(RefineAbsolutePose, WrongUseThrows) {
  const std::vector<Eigen::Vector3d> two(2, Eigen::Vector3d(0, 0, 1)), three(3, Eigen::Vector3d(0, 0, 1));
  EXPECT_THROW(refine_absolute_pose(Pose{}, two, two), std::invalid_argument);
  EXPECT_THROW(refine_absolute_pose(Pose{}, three, two), std::invalid_argument);
  EXPECT_THROW(refine_absolute_pose({2 * Eigen::Matrix3d::Identity(), {0, 0, 0}}, three, three),
               std::invalid_argument);
  // All points on one ray leave the camera free to move along and about it.
  EXPECT_TRUE(refine_absolute_pose(Pose{}, three, three).covariance.hasNaN());
}

}  // namespace
}  // namespace framewise
