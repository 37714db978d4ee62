// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_relative_pose.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/solvers/refine_input.h"
#include "framewise/solvers/refinement_for_tests.h"

namespace framewise {
namespace {

using testing::Random;
using testing::Scene;
constexpr EpipolarResidual kResiduals[] = {EpipolarResidual::kSampson, EpipolarResidual::kReprojection};

TEST(RefineRelativePose, ExactDataLeadBackToTheTruth) {
  Random random(1);
  for (const Scene scene : {Scene::kRandom, Scene::kOdometry, Scene::kPlanar, Scene::kForward})
    for (const ImageSurface surface : testing::kSurfaces)
      for (const EpipolarResidual residual : kResiduals)
        for (int trial = 0; trial < 20; ++trial) {
          const auto p = testing::make_problem(scene, 50, random);
          const Pose truth{p.cam2_from_cam1.R, p.cam2_from_cam1.t.normalized()};
          RefineOptions options;
          options.surface = surface;
          options.tolerance = 1e-16;
          const auto found = refine_relative_pose(testing::perturbed(truth, 1e-3, 1e-2, random), p.x1, p.x2,
                                                  options, residual);
          EXPECT_TRUE(found.converged);
          EXPECT_LT(testing::rotation_error(found.pose.R, truth.R), 1e-7) << name(scene);
          EXPECT_LT(testing::direction_error(found.pose.t, truth.t), 1e-5) << name(scene);
          EXPECT_NEAR(found.pose.t.norm(), 1, 1e-14);
        }
}

TEST(RefineRelativePose, CovarianceIsConsistentAndTheEstimateUnbiased) {
  for (const double sigma : {0.5 / 525, 1.0 / 525})
    for (const ImageSurface surface : testing::kSurfaces) {
      Random random(2);
      RefineOptions options;
      options.sigma = sigma;
      options.surface = surface;
      testing::Consistency consistency[2];
      int stuck = 0;
      for (int trial = 0; trial < 1000; ++trial) {
        const auto p = testing::make_problem(Scene::kRandom, 50, random);
        const auto x1 = testing::noisy_rays(p.x1, surface, sigma, random);
        const auto x2 = testing::noisy_rays(p.x2, surface, sigma, random);
        const Pose initial = testing::perturbed(p.cam2_from_cam1, 0.01, 0.02, random);
        for (const EpipolarResidual residual : kResiduals) {
          const auto found = refine_relative_pose(initial, x1, x2, options, residual);
          stuck += !found.converged;
          consistency[static_cast<int>(residual)].add(
              testing::error_up_to_scale(found.pose, p.cam2_from_cam1),
              testing::covariance_up_to_scale(found.pose, found.covariance));
        }
      }
      EXPECT_LE(stuck, 2);  // flat valleys, where the steps left are far below a sigma
      for (const auto& c : consistency) {
        EXPECT_NEAR(c.nees(), 1, 0.1) << "sigma " << sigma;
        EXPECT_LT(c.bias(), 4) << "sigma " << sigma;
      }
    }
}

TEST(RefineRelativePose, CovarianceSaysNothingAlongTheTranslation) {
  Random random(3);
  const auto p = testing::make_problem(Scene::kRandom, 30, random);
  const auto found = refine_relative_pose(p.cam2_from_cam1, p.x1, p.x2);
  Vector6d along = Vector6d::Zero();
  along.tail<3>() = found.pose.t;
  EXPECT_LT((found.covariance * along).norm(), 1e-15);
  EXPECT_EQ(found.covariance, found.covariance.transpose());
  EXPECT_GT(found.covariance.diagonal().minCoeff(), 0);
}

TEST(RefineRelativePose, CostIsThatOfTheDegreesOfFreedomLeft) {
  Random random(4);
  double sum = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = testing::make_problem(Scene::kRandom, 55, random);
    const auto x1 = testing::noisy_rays(p.x1, ImageSurface::kPlane, 1e-3, random);
    const auto x2 = testing::noisy_rays(p.x2, ImageSurface::kPlane, 1e-3, random);
    sum += refine_relative_pose(p.cam2_from_cam1, x1, x2).cost;
  }
  EXPECT_NEAR(sum / 200, 50, 5 * 10 / std::sqrt(200.0));
}

TEST(RefineRelativePose, RobustLossesForgetOutliers) {
  Random random(5);
  for (const Loss kind : {Loss::kHuber, Loss::kCauchy, Loss::kTruncated, Loss::kTukey}) {
    double robust = 0, plain = 0;
    for (int trial = 0; trial < 50; ++trial) {
      const auto p = testing::make_problem(Scene::kRandom, 100, random);
      const auto x1 = testing::noisy_rays(p.x1, ImageSurface::kPlane, 1e-3, random);
      auto x2 = testing::noisy_rays(p.x2, ImageSurface::kPlane, 1e-3, random);
      for (int i = 0; i < 10; ++i)
        x2[i] += Eigen::Vector3d(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0);
      const Pose initial = testing::perturbed(p.cam2_from_cam1, 0.002, 0.005, random);
      RefineOptions options;
      options.loss.threshold = 4;
      plain +=
          testing::rotation_error(refine_relative_pose(initial, x1, x2, options).pose.R, p.cam2_from_cam1.R);
      options.loss.kind = kind;
      robust +=
          testing::rotation_error(refine_relative_pose(initial, x1, x2, options).pose.R, p.cam2_from_cam1.R);
    }
    EXPECT_LT(robust, 0.4 * plain) << int(kind);
  }
}

TEST(RefineRelativePose, DirectionInformationTellsParallaxFromNoise) {
  Random random(6);
  const double sigma = 1.0 / 525;
  const auto ratio = [&](Scene scene, ImageSurface surface) {
    std::vector<double> ratios;
    for (int trial = 0; trial < 61; ++trial) {
      const auto p = testing::make_problem(scene, 200, random);
      const auto x1 = testing::noisy_rays(p.x1, surface, sigma, random);
      const auto x2 = testing::noisy_rays(p.x2, surface, sigma, random);
      RefineOptions options;
      options.sigma = sigma;
      options.surface = surface;
      PointColumns pairs;
      fill_ray_pairs(pairs, x1, x2, surface);
      const Pose initial{p.cam2_from_cam1.R,
                         scene == Scene::kPureRotation ? random.direction() : p.cam2_from_cam1.t};
      const auto found = refine_relative_pose(initial, pairs, options);
      const DirectionInformation direction = direction_information(found.pose, pairs, options);
      ratios.push_back(direction.measured / direction.feigned);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios;
  };
  for (const ImageSurface surface : testing::kSurfaces) {
    EXPECT_LT(ratio(Scene::kPureRotation, surface)[57], 4);
    EXPECT_LT(ratio(Scene::kTinyBaseline, surface)[57], 4);
    EXPECT_GT(ratio(Scene::kRandom, surface)[3], 5);
    EXPECT_GT(ratio(Scene::kOdometry, surface)[30], 3);
  }
}

TEST(RefineRelativePose, WithParallaxAboveTheNoiseCovarianceIsHonestForSmallMotionsToo) {
  Random random(10);
  RefineOptions options;
  options.sigma = 1.0 / 525;
  testing::Consistency clear, unclear;
  for (int trial = 0; trial < 500; ++trial) {
    const auto p = testing::make_problem(Scene::kOdometry, 200, random);
    PointColumns pairs;
    fill_ray_pairs(pairs, testing::noisy_rays(p.x1, options.surface, options.sigma, random),
                   testing::noisy_rays(p.x2, options.surface, options.sigma, random), options.surface);
    const auto found = refine_relative_pose(p.cam2_from_cam1, pairs, options);
    const DirectionInformation direction = direction_information(found.pose, pairs, options);
    (direction.measured > 4 * direction.feigned ? clear : unclear)
        .add(testing::error_up_to_scale(found.pose, p.cam2_from_cam1),
             testing::covariance_up_to_scale(found.pose, found.covariance));
  }
  EXPECT_NEAR(clear.nees(), 1, 0.15);
  EXPECT_GT(unclear.nees(), 1.5);
}

TEST(RefineRelativePose, SwappedViewsGiveTheInverse) {
  Random random(7);
  const auto p = testing::make_problem(Scene::kRandom, 40, random);
  const auto x1 = testing::noisy_rays(p.x1, ImageSurface::kPlane, 1e-3, random);
  const auto x2 = testing::noisy_rays(p.x2, ImageSurface::kPlane, 1e-3, random);
  for (const EpipolarResidual residual : kResiduals) {
    const auto forth = refine_relative_pose(p.cam2_from_cam1, x1, x2, {}, residual);
    const auto back = refine_relative_pose(p.cam2_from_cam1.inverse(), x2, x1, {}, residual);
    EXPECT_LT(testing::rotation_error(forth.pose.R, back.pose.inverse().R), 1e-6);
    EXPECT_LT(testing::direction_error(forth.pose.t, back.pose.inverse().t), 1e-5);
    EXPECT_NEAR(forth.cost, back.cost, 1e-6);
  }
}

TEST(RefineRelativePose, DegenerateDataGiveNoNanPose) {
  Random random(8);
  const auto p = testing::make_problem(Scene::kPureRotation, 20, random);
  const std::vector<Eigen::Vector3d> same(10, Eigen::Vector3d(0.1, 0.2, 1));
  for (const EpipolarResidual residual : kResiduals) {
    EXPECT_TRUE(refine_relative_pose({p.cam2_from_cam1.R, {1, 0, 0}}, p.x1, p.x2, {}, residual)
                    .pose.matrix()
                    .allFinite());
    const auto repeated = refine_relative_pose({p.cam2_from_cam1.R, {1, 0, 0}}, same, same, {}, residual);
    EXPECT_TRUE(repeated.pose.matrix().allFinite());
    EXPECT_TRUE(repeated.covariance.hasNaN());
  }
}

TEST(RefineRelativePose, WrongUseThrows) {
  Random random(9);
  auto p = testing::make_problem(Scene::kRandom, 10, random);
  const std::vector<Eigen::Vector3d> few(4, Eigen::Vector3d(0, 0, 1)), nine(9, Eigen::Vector3d(0, 0, 1));
  EXPECT_THROW(refine_relative_pose(Pose{}, p.x1, p.x2), std::invalid_argument);  // t = 0
  EXPECT_THROW(refine_relative_pose(p.cam2_from_cam1, few, few), std::invalid_argument);
  EXPECT_THROW(refine_relative_pose(p.cam2_from_cam1, p.x1, nine), std::invalid_argument);
  RefineOptions options;
  options.sigma = 0;
  EXPECT_THROW(refine_relative_pose(p.cam2_from_cam1, p.x1, p.x2, options), std::invalid_argument);
  p.x2[3].y() = NAN;
  EXPECT_THROW(refine_relative_pose(p.cam2_from_cam1, p.x1, p.x2), std::invalid_argument);
  p.x2[3] = {0, 0, 0};
  EXPECT_THROW(refine_relative_pose(p.cam2_from_cam1, p.x1, p.x2), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
