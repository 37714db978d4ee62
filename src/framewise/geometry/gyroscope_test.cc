// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/gyroscope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A coning motion, R(t) = Rz(a t) Rx(b) Rz(-a t): its axis turns all the time, and its rates in the body's
// axes are known in closed form.
constexpr double kTurn = 3, kTilt = 0.4;
Matrix3d coning(double t) {
  return so3_exp({0, 0, kTurn * t}) * so3_exp({kTilt, 0, 0}) * so3_exp({0, 0, -kTurn * t});
}
Vector3d coning_rate(double t) {
  // omega = R' (a ez) - a ez, R' the transpose.
  return coning(t).transpose() * Vector3d(0, 0, kTurn) - Vector3d(0, 0, kTurn);
}

Gyroscope sampled(double step, double end = 2) {
  Gyroscope gyroscope;
  for (int i = 0; i * step <= end + 1e-9; ++i) {
    gyroscope.times.push_back(i * step);
    gyroscope.rates.push_back(coning_rate(i * step));
  }
  return gyroscope;
}

double error_of(const Gyroscope& gyroscope, double time1, double time2) {
  const auto R = rotation_between(gyroscope, time1, time2, 1.0);
  EXPECT_TRUE(R);
  if (!R) return std::numeric_limits<double>::infinity();
  return rotation_angle(*R * coning(time1).transpose() * coning(time2));
}

TEST(Gyroscope, AConstantRateIsExact) {
  Gyroscope gyroscope;
  gyroscope.times = {0, 0.1, 0.3, 0.35, 1};
  gyroscope.rates.assign(5, Vector3d(0.3, -1.2, 0.5));
  const auto R = rotation_between(gyroscope, 0.05, 0.9, 1.0);
  ASSERT_TRUE(R);
  // The camera turns by +0.85 w, so points turn the other way.
  EXPECT_LT((*R - so3_exp(-0.85 * Vector3d(0.3, -1.2, 0.5))).norm(), 1e-14);
}

TEST(Gyroscope, FollowsAConingMotionWhoseAxisTurns) {
  EXPECT_LT(error_of(sampled(0.005), 0.0123, 1.987), 2e-5);
}

TEST(Gyroscope, TheErrorFallsWithTheSquareOfTheStepAtLeast) {
  const double coarse = error_of(sampled(0.02), 0, 1.9), fine = error_of(sampled(0.01), 0, 1.9);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, coarse / 3.5);
}

TEST(Gyroscope, StretchesJoin) {
  const Gyroscope gyroscope = sampled(0.01);
  const auto whole = rotation_between(gyroscope, 0.1234, 1.4567, 0.1);
  const auto first = rotation_between(gyroscope, 0.1234, 0.7, 0.1),
             second = rotation_between(gyroscope, 0.7, 1.4567, 0.1);
  ASSERT_TRUE(whole && first && second);
  EXPECT_LT((*whole - *second * *first).norm(), 1e-12);
}

TEST(Gyroscope, TheWayBackIsTheInverse) {
  const Gyroscope gyroscope = sampled(0.01);
  const auto there = rotation_between(gyroscope, 0.2, 0.9, 0.1),
             back = rotation_between(gyroscope, 0.9, 0.2, 0.1);
  ASSERT_TRUE(there && back);
  EXPECT_TRUE((*there * *back).isIdentity(1e-12));
  EXPECT_TRUE(rotation_between(gyroscope, 0.2, 0.2, 0.1)->isIdentity(0));
}

TEST(Gyroscope, TurnsAreToldInTheCamerasAxes) {
  Gyroscope gyroscope;
  gyroscope.times = {0, 1};
  gyroscope.rates.assign(2, Vector3d(0, 0, 0.5));          // yaw to the left of a body with z up
  gyroscope.cam_from_gyro << 0, -1, 0, 0, 0, -1, 1, 0, 0;  // x right = -y, y down = -z, z forward = x
  EXPECT_LT((*rotation_between(gyroscope, 0, 1, 1) - so3_exp({0, 0.5, 0})).norm(), 1e-15);
}

TEST(Gyroscope, KnowsNothingOutsideAndAcrossGaps) {
  Gyroscope gyroscope = sampled(0.1, 1);
  EXPECT_FALSE(rotation_between(gyroscope, -0.01, 0.5, 0.2));
  EXPECT_FALSE(rotation_between(gyroscope, 0.5, 1.01, 0.2));
  EXPECT_TRUE(rotation_between(gyroscope, 0, 1, 0.2));
  EXPECT_FALSE(rotation_between(gyroscope, 0, std::nan(""), 0.2));
  EXPECT_FALSE(rotation_between(gyroscope, std::nan(""), 1, 0.2));
  gyroscope.times.erase(gyroscope.times.begin() + 5);
  gyroscope.rates.erase(gyroscope.rates.begin() + 5);
  EXPECT_FALSE(rotation_between(gyroscope, 0.2, 0.8, 0.15));
  EXPECT_TRUE(rotation_between(gyroscope, 0.2, 0.4, 0.15));
  EXPECT_FALSE(rotation_between(Gyroscope(), 0, 0, 1));
  gyroscope.rates.pop_back();
  EXPECT_THROW(rotation_between(gyroscope, 0.2, 0.4, 0.15), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
