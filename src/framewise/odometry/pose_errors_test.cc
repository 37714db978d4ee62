// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/pose_errors.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "framewise/geometry/so3.h"
#include "framewise/odometry/map_placement.h"
#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::Random;

constexpr double kRaySigma = 0.3 / 500, kInverseDepthSigma = 0.004;

// A point of the world where its host's errors have put it in the map, in the host's axes.
struct MappedPoint {
  PointRef ref;
  Eigen::Vector3d truth;  // in the world
  Eigen::Vector3d mapped;
  Eigen::Matrix3d covariance;
};

std::vector<MappedPoint> points_of(int keyframe, const Pose& world_from_cam, int count, Random& random) {
  std::vector<MappedPoint> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d ray(random.uniform(-0.6, 0.6), random.uniform(-0.45, 0.45), 1);
    const double z = random.uniform(2, 6), seen_z = 1 / (1 / z + kInverseDepthSigma * random.normal());
    points.push_back({{keyframe, i},
                      world_from_cam * (z * ray),
                      seen_z * ray,
                      std::pow(kInverseDepthSigma * seen_z * seen_z, 2) * ray * ray.transpose()});
  }
  return points;
}

// What a camera measures of the points: placed from where the one before is believed to be.
Placed place_by(const std::vector<MappedPoint>& points, const std::vector<Pose>& believed_hosts,
                const Pose& truth, const Pose& world_from_before, Random& random) {
  Placed placed;
  for (const MappedPoint& point : points) {
    const Pose before_from_host = world_from_before.inverse() * believed_hosts[point.ref.keyframe];
    const Eigen::Vector3d x = truth.inverse() * point.truth;
    MapMatch match;
    match.X = before_from_host * point.mapped;
    match.S = before_from_host.R * point.covariance * before_from_host.R.transpose();
    match.ray = x / x.z() + kRaySigma * Eigen::Vector3d(random.normal(), random.normal(), 0);
    match.noise.sigma = kRaySigma;
    match.z = std::numeric_limits<double>::quiet_NaN();
    placed.matches.push_back(match);
    placed.points.push_back({point.ref, Eigen::Vector2d::Zero(), match.ray, 0.3});
  }
  placed.pose = refine_map_pose(placed.matches, truth.inverse() * world_from_before, {});
  return placed;
}

double nees(const Pose& found, const Pose& truth, const Matrix6d& covariance) {
  Vector6d error;
  error << so3_log(truth.R.transpose() * found.R), found.t - truth.t;
  return error.dot(covariance.ldlt().solve(error)) / 6;
}

const Pose kFirst{so3_exp({0.02, -0.04, 0.01}), {0.15, 0.03, 0.1}};
const Pose kSecond{so3_exp({0.03, -0.07, 0.03}), {0.3, 0.05, 0.25}};

// Mean squared error of the step between two cameras over what is said of it: the first is placed by the
// points of a keyframe, and may be one itself for the second.
double mean_nees(bool becomes_keyframe) {
  Random random(3);
  double mean = 0;
  constexpr int kTrials = 150;
  for (int trial = 0; trial < kTrials; ++trial) {
    PoseErrors errors;
    errors.start(0, 1);
    std::vector<MappedPoint> points = points_of(0, {}, 80, random);
    std::vector<Pose> hosts = {{}};
    const Placed first = place_by(points, hosts, kFirst, {}, random);
    const Pose world_from_first = first.pose.cam_from_reference.inverse();
    errors.placed(world_from_first, placed_by(first, {}));
    if (becomes_keyframe) {
      errors.become_keyframe(0);
      hosts.push_back(world_from_first);
      for (const MappedPoint& point : points_of(1, kFirst, 80, random)) points.push_back(point);
    }
    const Placed second = place_by(points, hosts, kSecond, world_from_first, random);
    const Pose world_from_second = world_from_first * second.pose.cam_from_reference.inverse();
    errors.placed(world_from_second, placed_by(second, {}));
    mean += nees(second.pose.cam_from_reference, kSecond.inverse() * kFirst,
                 errors.step_covariance(world_from_first, world_from_second)) /
            kTrials;
  }
  return mean;
}

TEST(PoseErrors, StepsErrByWhatIsSaidOfThem) {
  EXPECT_GT(mean_nees(false), 0.8);
  EXPECT_LT(mean_nees(false), 1.25);
}

TEST(PoseErrors, StepsFromAKeyframeErrByWhatIsSaidOfThem) {
  EXPECT_GT(mean_nees(true), 0.8);
  EXPECT_LT(mean_nees(true), 1.25);
}

// Points whose residuals are noise, or the same in each frame.
std::vector<PlacedBy> residuals(bool anew, Random& random) {
  std::vector<PlacedBy> points;
  Random same(9);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d x(same.uniform(-1.2, 1.2), same.uniform(-0.9, 0.9), 2);
    Random& source = anew ? random : same;
    const Eigen::Vector2d r(source.normal(), source.normal());
    points.push_back({{0, i}, x, Eigen::Matrix3d::Zero(), 0.001 * r, {0.001}});
  }
  return points;
}

TEST(PoseErrors, WhatBothCamerasErrByAlikeIsNotInTheStep) {
  double sigma[2];
  for (const bool anew : {false, true}) {
    Random random(5);
    PoseErrors errors;
    errors.start(0, 1);
    for (int frame = 0; frame < 3; ++frame) errors.placed({}, residuals(anew, random));
    sigma[anew] = std::sqrt(errors.step_covariance({}, {}).trace());
  }
  EXPECT_LT(sigma[false], 0.05 * sigma[true]);
}

TEST(PoseErrors, AnErrorOfTheKeyframeIsNotInTheStepsOfThoseThatItPlaces) {
  Random random(6);
  double trace[2];
  for (const bool is_off : {false, true}) {
    PoseErrors errors;
    errors.start(0, 1);
    if (is_off) errors.moved({}, Matrix6d::Identity()), errors.become_keyframe(0);
    std::vector<PlacedBy> points = residuals(false, random);
    for (PlacedBy& point : points) point.ref.keyframe = is_off;
    errors.placed({}, points);
    errors.placed({}, points);
    trace[is_off] = errors.step_covariance({}, {}).trace();
  }
  EXPECT_NEAR(trace[true], trace[false], 1e-9);
}

TEST(PoseErrors, AMotionThatWasForetoldErrsByWhatWasSaid) {
  PoseErrors errors;
  errors.start(0, 1);
  Matrix6d said = Matrix6d::Zero();
  said.diagonal() << 1e-4, 2e-4, 3e-4, 1e-2, 2e-2, 3e-2;
  const Pose at{so3_exp({0.3, -0.2, 0.1}), {5, -3, 2}};
  errors.moved(at, said);
  const Matrix6d step = errors.step_covariance(at, at);  // of cam2_from_cam1: rotation in the camera's axes
  const Vector6d variances = step.diagonal(), expected = said.diagonal();
  EXPECT_LT((variances - expected).head<3>().norm(), 1e-12);
  EXPECT_NEAR(variances.tail<3>().sum(), expected.tail<3>().sum(), 1e-9);
}

TEST(PoseErrors, AHalfTakenMeasurementLeavesHalfOfItsNoise) {
  Matrix6d step[2];
  for (const bool half : {false, true}) {
    Random random(7);
    PoseErrors errors;
    errors.start(0, 1);
    errors.placed({}, residuals(true, random));
    if (half) errors.drawn_to_prior({}, {0.5, 0.5, 0, 0});
    step[half] = errors.step_covariance({}, {});
  }
  EXPECT_LT((4 * step[true] - step[false]).norm(), 1e-6 * step[false].norm());
}

TEST(PoseErrors, TooFewPointsTellNothing) {
  PoseErrors errors;
  errors.start(0, 1);
  errors.placed({}, {});
  EXPECT_GT(errors.step_covariance({}, {}).diagonal().minCoeff(), 0.9);
}

TEST(PoseErrors, OldKeyframesAreForgotten) {
  Random random(8);
  PoseErrors errors;
  errors.start(0, 1);
  for (int i = 0; i < 5; ++i) {
    std::vector<PlacedBy> points = residuals(true, random);
    for (PlacedBy& point : points) point.ref.keyframe = i;
    errors.placed({}, points);
    errors.become_keyframe(i + 1);
    EXPECT_TRUE(errors.step_covariance({}, {}).allFinite());
  }
}

}  // namespace
}  // namespace framewise
