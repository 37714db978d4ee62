// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_rgbd_pair.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/solvers/refine_absolute_pose.h"
#include "framewise/solvers/refinement_for_tests.h"

namespace framewise {
namespace {

using testing::Random;
using testing::Scene;

struct RgbdPair {
  std::vector<Eigen::Vector3d> x1, x2;
  std::vector<double> z1, z2;
};

// Depth noise `level` times, and a share of the depths missing in each view.
RgbdPair seen(const testing::TwoViewProblem& p, double sigma, const DepthNoise& noise, double missing,
              Random& random) {
  RgbdPair pair;
  pair.x1 = testing::noisy_rays(p.x1, ImageSurface::kPlane, sigma, random);
  pair.x2 = testing::noisy_rays(p.x2, ImageSurface::kPlane, sigma, random);
  const auto depth = [&](double z) {
    const double measured = z + noise.sigma(z) * random.normal();
    return random.uniform(0, 1) < missing ? NAN : measured;
  };
  for (std::size_t i = 0; i < p.X1.size(); ++i)
    pair.z1.push_back(depth(p.X1[i].z())), pair.z2.push_back(depth(p.X2[i].z()));
  return pair;
}

DepthNoise scaled(double level) { return {level * 0.0012, level * 0.0019, 0.4}; }

TEST(RefineRgbdPair, ExactDataLeadBackToTheTruth) {
  Random random(1);
  for (const Scene scene : testing::kAllScenes) {
    const auto p = testing::make_problem(scene, 40, random);
    RgbdPair pair = seen(p, 0, scaled(0), 0.4, random);
    const auto found = refine_rgbd_pair(testing::perturbed(p.cam2_from_cam1, 0.01, 0.05, random), pair.x1,
                                        pair.z1, pair.x2, pair.z2);
    EXPECT_TRUE(found.converged);
    EXPECT_LT(testing::rigid_error(found.pose, p.cam2_from_cam1).norm(), 1e-6) << name(scene);
  }
}

TEST(RefineRgbdPair, CovarianceIsConsistentAndTheEstimateUnbiased) {
  for (const double level : {0.5, 1.0})
    for (const double missing : {0.0, 0.5, 0.9}) {
      // With hardly a depth left, little motion is the rays' own trouble (direction_information).
      const Scene scene = missing > 0.5 ? Scene::kRandom : Scene::kOdometry;
      Random random(2);
      testing::Consistency consistency;
      int stuck = 0;
      for (int trial = 0; trial < 1000; ++trial) {
        const auto p = testing::make_problem(scene, 50, random);
        RefineOptions options;
        options.sigma = level / 525;
        const RgbdPair pair = seen(p, options.sigma, scaled(level), missing, random);
        const auto found = refine_rgbd_pair(testing::perturbed(p.cam2_from_cam1, 0.01, 0.02, random), pair.x1,
                                            pair.z1, pair.x2, pair.z2, scaled(level), options);
        stuck += !found.converged;
        consistency.add(testing::rigid_error(found.pose, p.cam2_from_cam1), found.covariance);
      }
      EXPECT_LE(stuck, 2);  // flat valleys, where the steps left are far below a sigma
      EXPECT_NEAR(consistency.nees(), 1, 0.1) << "level " << level << " missing " << missing << name(scene);
      EXPECT_LT(consistency.bias(), 4) << "level " << level << " missing " << missing << name(scene);
    }
}

TEST(RefineRgbdPair, EveryDepthMoreMakesThePoseSurer) {
  Random random(3);
  const auto p = testing::make_problem(Scene::kOdometry, 40, random);
  RgbdPair pair = seen(p, 1e-3, scaled(1), 0, random);
  double before = 0;
  for (const std::size_t known : {40, 30, 20, 10, 3}) {
    for (std::size_t i = known; i < 40; ++i) (i % 2 ? pair.z1 : pair.z2)[i] = NAN;
    const double trace =
        refine_rgbd_pair(p.cam2_from_cam1, pair.x1, pair.z1, pair.x2, pair.z2).covariance.trace();
    EXPECT_GT(trace, before);
    before = trace;
  }
}

TEST(RefineRgbdPair, BothDepthsBeatReprojectionAlone) {
  Random random(4);
  double both = 0, reprojection = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto p = testing::make_problem(Scene::kOdometry, 100, random);
    const RgbdPair pair = seen(p, 1e-3, scaled(1), 0, random);
    std::vector<Eigen::Vector3d> X1;
    for (std::size_t i = 0; i < pair.x1.size(); ++i) X1.push_back(point_at_depth(pair.x1[i], pair.z1[i]));
    const Pose initial = refine_absolute_pose(p.cam2_from_cam1, X1, pair.x2).pose;
    reprojection += (initial.t - p.cam2_from_cam1.t).norm();
    both +=
        (refine_rgbd_pair(initial, pair.x1, pair.z1, pair.x2, pair.z2).pose.t - p.cam2_from_cam1.t).norm();
  }
  EXPECT_LT(both, reprojection);
}

TEST(RefineRgbdPair, WithoutAnyDepthTheScaleIsUnknownAndSaidSo) {
  Random random(5);
  const auto p = testing::make_problem(Scene::kRandom, 40, random);
  const std::vector<double> none(40, NAN);
  const auto found = refine_rgbd_pair(p.cam2_from_cam1, p.x1, none, p.x2, none);
  EXPECT_TRUE(found.covariance.hasNaN());
  EXPECT_TRUE(found.pose.matrix().allFinite());
}

TEST(RefineRgbdPair, WrongUseThrows) {
  std::vector<Eigen::Vector3d> x(4, Eigen::Vector3d(0, 0, 1));
  const std::vector<double> z(4, 1.0), three(3, 1.0);
  EXPECT_THROW(refine_rgbd_pair(Pose{}, x, three, x, z), std::invalid_argument);
  EXPECT_THROW(refine_rgbd_pair(Pose{}, x, z, x, z, DepthNoise{-1, 0, 0}), std::invalid_argument);
  x[2] = {0, 0, -1};
  EXPECT_THROW(refine_rgbd_pair(Pose{}, x, z, x, z), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
