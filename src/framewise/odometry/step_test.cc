// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"
#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::Random;

constexpr double kFocal = 525;
const Camera kCamera{CameraModel::kPinhole, 640, 480, kFocal, kFocal, 319.5, 239.5};
const double kNan = std::numeric_limits<double>::quiet_NaN();

// Points before two cameras, seen with the noise that the options tell of; the first `wrong` are paired with
// something else.
Correspondences see(const Pose& cam2_from_cam1, int size, int wrong, const OdometryOptions& options,
                    Random& random) {
  Correspondences shared;
  shared.has_depth = true;
  const double sigma = options.keypoint_sigma_px / kFocal;
  const auto seen = [&](const Eigen::Vector3d& X) {
    return Bearing(X.x() / X.z() + sigma * random.normal(), X.y() / X.z() + sigma * random.normal(), 1)
        .normalized();
  };
  const auto depth = [&](double z) { return z + options.depth_noise.sigma(z) * random.normal(); };
  for (int i = 0; i < size; ++i) {
    const double z = random.uniform(0.8, 4);
    const Eigen::Vector3d X1(random.uniform(-0.5, 0.5) * z, random.uniform(-0.4, 0.4) * z, z);
    Eigen::Vector3d X2 = cam2_from_cam1 * X1;
    if (i < wrong) X2 += Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1));
    shared.x1.push_back(seen(X1));
    shared.x2.push_back(seen(X2));
    shared.z1.push_back(depth(X1.z()));
    shared.z2.push_back(depth(X2.z()));
    shared.sigma1.push_back(sigma);
    shared.sigma2.push_back(sigma);
  }
  return shared;
}

const Pose kMotion{so3_exp({0.02, -0.03, 0.01}), {0.15, -0.05, 0.08}};

// In the tangent vector (rotation, translation).
Vector6d error_of(const Pose& pose, const Pose& truth) {
  Vector6d error;
  error << so3_log(truth.R.transpose() * pose.R), pose.t - truth.t;
  return error;
}

// Mean of error' covariance^-1 error / 6 over steps of kMotion: 1 where the covariance tells of the errors.
double mean_nees(const OdometryOptions& options, Random& random) {
  double nees = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Step step = estimate_step(see(kMotion, 200, 40, options, random), kCamera, options, trial);
    EXPECT_EQ(step.status, Status::kOk);
    const Vector6d error = error_of(step.cam2_from_cam1, kMotion);
    nees += error.dot(step.covariance.ldlt().solve(error)) / 6 / kTrials;
  }
  return nees;
}

TEST(EstimateStep, TheErrorsOfAMetricStepAreThoseItsCovarianceTellsOf) {
  Random random(1);
  for (const char* solver : {"kabsch", "p3p"}) {
    OdometryOptions options;
    options.solver = solver;
    const double nees = mean_nees(options, random);
    EXPECT_GT(nees, 0.6) << solver;
    EXPECT_LT(nees, 1.6) << solver;
  }
}

TEST(EstimateStep, CovarianceFollowsTheLengthOfTheStep) {
  Random random(2);
  OdometryOptions options;
  options.solver = "nister-5pt";
  options.scale = "none";
  const Correspondences shared = see(kMotion, 300, 60, options, random);
  const Step unit = estimate_step(shared, kCamera, options, 1);
  options.scale = "truth";
  const double length = kMotion.t.norm();
  const Step metric = estimate_step(shared, kCamera, options, 1, {.true_length = length});
  ASSERT_EQ(unit.status, Status::kOk);
  ASSERT_EQ(metric.status, Status::kOk);

  Vector6d units;
  units << 1, 1, 1, length, length, length;
  const Matrix6d expected = units.asDiagonal() * unit.covariance * units.asDiagonal();
  EXPECT_LT((metric.covariance - expected).norm(), 1e-12 * expected.norm());
  // Nothing is told along the direction of the step.
  const Eigen::Matrix3d of_t = unit.covariance.bottomRightCorner<3, 3>();
  EXPECT_LT((of_t * unit.cam2_from_cam1.t).norm(), 1e-6 * of_t.norm());
  const Vector6d error = error_of(metric.cam2_from_cam1, kMotion);
  for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(error[i]), 5 * std::sqrt(metric.covariance(i, i))) << i;
}

double length_error(const Step& step) {
  return (step.cam2_from_cam1.t - kMotion.t).norm() / kMotion.t.norm();
}

constexpr const char* kBearingSolvers[] = {"eight-point",        "seven-point", "nister-5pt", "stewenius-5pt",
                                           "kneip-5pt-rotation", "eigensolver", "two-point"};

TEST(EstimateStep, EverySolverAndScaleGivesTheMotion) {
  Random random(5);
  for (const char* solver : kBearingSolvers)
    for (const char* scale : {"depth", "centroid", "truth"})
      for (const char* ransac : {"on", "two-stage"}) {
        OdometryOptions options;
        options.solver = solver;
        options.scale = scale;
        options.ransac_scheme = ransac;
        options.check();
        const Correspondences shared = see(kMotion, 300, 60, options, random);
        const Step step = estimate_step(shared, kCamera, options, 1,
                                        {.true_length = kMotion.t.norm(), .rotation = kMotion.R});
        const std::string method = std::string(solver) + " " + scale + " " + ransac;
        ASSERT_TRUE(is_measured(step.status)) << method;
        EXPECT_LT(rotation_angle(kMotion.R.transpose() * step.cam2_from_cam1.R), 0.01) << method;
        EXPECT_LT(length_error(step), 0.2) << method;
      }
}

TEST(EstimateStep, EveryMeasureFindsTheRotationWhereTheParallaxIsSmall) {
  Random random(11);
  const Pose motion{kMotion.R, 0.2 * kMotion.t};
  for (const char* solver : kBearingSolvers)
    for (const char* error : {"reprojection", "bearing-euclidean"})
      for (const char* ransac : {"on", "two-stage"}) {
        OdometryOptions options;
        options.solver = solver;
        if (options.needs_rotation()) continue;  // knows the rotation
        options.error = error;
        options.ransac_scheme = ransac;
        options.scale = "none";
        options.check();
        const Step step = estimate_step(see(motion, 300, 60, options, random), kCamera, options, 1);
        const std::string method = std::string(solver) + " " + error + " " + ransac;
        ASSERT_TRUE(is_measured(step.status)) << method;
        EXPECT_LT(rotation_angle(motion.R.transpose() * step.cam2_from_cam1.R), 0.02) << method;
      }
}

TEST(EstimateStep, DepthMakesAStepFromBearingsAsGoodAsOneFromPoints) {
  Random random(7);
  OdometryOptions bearings, points;
  bearings.solver = "nister-5pt";
  double of_bearings = 0, of_points = 0, nees = 0;
  constexpr int kTrials = 30;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Correspondences shared = see(kMotion, 200, 40, bearings, random);
    const Step step = estimate_step(shared, kCamera, bearings, trial);
    ASSERT_EQ(step.status, Status::kOk);
    of_bearings += length_error(step);
    of_points += length_error(estimate_step(shared, kCamera, points, trial));
    const Vector6d error = error_of(step.cam2_from_cam1, kMotion);
    nees += error.dot(step.covariance.ldlt().solve(error)) / 6 / kTrials;
  }
  EXPECT_LT(of_bearings, 1.1 * of_points);
  EXPECT_GT(nees, 0.6);
  EXPECT_LT(nees, 1.6);
}

TEST(EstimateStep, DepthTellsTheTranslationWhereThereIsNoParallax) {
  Random random(8);
  const Pose turned{kMotion.R, {0.001, 0, 0.0005}};
  OdometryOptions options;
  options.solver = "nister-5pt";
  const Correspondences shared = see(turned, 300, 0, options, random);
  const Step metric = estimate_step(shared, kCamera, options, 1);
  ASSERT_EQ(metric.status, Status::kOk);
  const Vector6d error = error_of(metric.cam2_from_cam1, turned);
  for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(error[i]), 5 * std::sqrt(metric.covariance(i, i))) << i;
  options.scale = "none";
  EXPECT_EQ(estimate_step(shared, kCamera, options, 1).status, Status::kRotationOnly);
}

TEST(EstimateStep, TwoPointKeepsTheRotationItIsGivenAndIsLostWithoutOne) {
  Random random(9);
  OdometryOptions options;
  options.solver = "two-point";
  options.scale = "none";
  const Correspondences shared = see(kMotion, 200, 40, options, random);
  const Step step = estimate_step(shared, kCamera, options, 1, {.rotation = kMotion.R});
  ASSERT_EQ(step.status, Status::kOk);
  EXPECT_EQ(step.cam2_from_cam1.R, kMotion.R);
  EXPECT_LT(testing::direction_error(step.cam2_from_cam1.t, kMotion.t), 0.03);
  EXPECT_EQ(estimate_step(shared, kCamera, options, 1).status, Status::kLost);
}

TEST(EstimateStep, OffRejectsNothing) {
  Random random(10);
  for (const char* solver : {"kabsch", "nister-5pt", "eight-point"}) {
    OdometryOptions options;
    options.solver = solver;
    options.ransac_scheme = "off";
    const Correspondences shared = see(kMotion, 200, 0, options, random);
    const Step step = estimate_step(shared, kCamera, options, 1);
    ASSERT_EQ(step.status, Status::kOk) << solver;
    EXPECT_EQ(step.inliers, 200) << solver;
    EXPECT_LT(rotation_angle(kMotion.R.transpose() * step.cam2_from_cam1.R), 0.3) << solver;
  }
}

TEST(EstimateStep, TheMaskTellsWhichCorrespondencesAgree) {
  Random random(3);
  for (const char* solver : {"kabsch", "nister-5pt"}) {
    OdometryOptions options;
    options.solver = solver;
    Correspondences shared = see(kMotion, 200, 50, options, random);
    // What has no depth agrees with no motion of points.
    for (int i = 60; i < 80; ++i) shared.z1[i] = kNan;
    const Step step = estimate_step(shared, kCamera, options, 3);
    ASSERT_EQ(step.status, Status::kOk) << solver;
    ASSERT_EQ(step.inlier_mask.size(), shared.size());
    EXPECT_EQ(std::count(step.inlier_mask.begin(), step.inlier_mask.end(), 1), step.inliers);
    EXPECT_LE(std::count(step.inlier_mask.begin(), step.inlier_mask.begin() + 50, 1), 5) << solver;
    EXPECT_GE(std::count(step.inlier_mask.begin() + 80, step.inlier_mask.end(), 1), 110) << solver;
    EXPECT_EQ(std::count(step.inlier_mask.begin() + 60, step.inlier_mask.begin() + 80, 1) == 0,
              options.is_metric());
  }
}

TEST(EstimateStep, WhatIsNotMeasuredHasNeitherMaskNorCovariance) {
  Random random(4);
  OdometryOptions options;
  const auto expect_nothing = [&](const Correspondences& shared, Status status) {
    const Step step = estimate_step(shared, kCamera, options, 0);
    EXPECT_EQ(name(step.status), name(status));
    EXPECT_EQ(step.matches, static_cast<int>(shared.size()));
    EXPECT_TRUE(step.covariance.array().isNaN().all());
    EXPECT_TRUE(step.inlier_mask.empty());
  };
  expect_nothing({}, Status::kNoDepth);
  Correspondences shared = see(kMotion, 100, 0, options, random);
  shared.has_depth = false;
  expect_nothing(shared, Status::kNoDepth);
  shared = see(kMotion, 100, 0, options, random);
  std::fill(shared.z2.begin(), shared.z2.end(), kNan);
  expect_nothing(shared, Status::kNoDepth);
  shared = {};
  shared.has_depth = true;
  expect_nothing(shared, Status::kLost);
  shared = see(kMotion, 60, 60, options, random);
  expect_nothing(shared, Status::kLost);
}

}  // namespace
}  // namespace framewise
