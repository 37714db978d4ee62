// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/motion_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr double kRate = 30;

Matrix6d noise(double rotation, double position) {
  Vector6d variances;
  variances << Eigen::Vector3d::Constant(rotation * rotation), Eigen::Vector3d::Constant(position * position);
  return variances.asDiagonal();
}

// Three numbers of mean 0, each even over +-sqrt(3) sigma.
Eigen::Vector3d draw(std::mt19937& random, double sigma) {
  const auto one = [&] {
    return (static_cast<double>(random()) / 4294967295.0 - 0.5) * std::sqrt(12.0) * sigma;
  };
  return {one(), one(), one()};
}

Pose steady(double time) { return {so3_exp({0, 0.5 * time, 0}), {0.3 * time, 0, -0.1 * time}}; }

TEST(MotionFilter, ForetellsASteadyMotionExactly) {
  MotionFilter filter(true);
  filter.start(0, steady(0));
  for (int i = 1; i <= 30; ++i) filter.update(i / kRate, steady(i / kRate), noise(1e-9, 1e-9));
  const Pose predicted = filter.predict(31 / kRate), expected = steady(31 / kRate);
  EXPECT_LT((predicted.t - expected.t).norm(), 1e-6);
  EXPECT_LT(rotation_angle(predicted.R.transpose() * expected.R), 1e-6);
}

TEST(MotionFilter, AStandingCameraMovesLessThanItsNoise) {
  std::mt19937 random(4);
  MotionFilter filter(true);
  filter.start(0, {});
  constexpr double kSigma = 2e-3;
  double measured = 0, believed = 0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero(), noisy_before = before;
  for (int i = 1; i <= 400; ++i) {
    const Pose noisy{so3_exp(draw(random, kSigma)), draw(random, kSigma)};
    const Pose pose = filter.update(i / kRate, noisy, noise(kSigma, kSigma));
    if (i > 100)
      measured += (noisy.t - noisy_before).squaredNorm(), believed += (pose.t - before).squaredNorm();
    before = pose.t, noisy_before = noisy.t;
  }
  EXPECT_LT(believed, 0.25 * measured);
}

// A third of the noise was said; the swing of what is measured shows the rest.
TEST(MotionFilter, NoiseThatWasUnderstatedIsSeenInTheSwing) {
  constexpr double kSigma = 2e-3;
  const auto error = [&](double said) {
    std::mt19937 random(7);
    MotionFilter filter(true);
    filter.start(0, steady(0));
    double squares = 0;
    for (int i = 1; i <= 400; ++i) {
      Pose noisy = steady(i / kRate);
      noisy.R = noisy.R * so3_exp(draw(random, kSigma)), noisy.t += draw(random, kSigma);
      const Pose pose = filter.update(i / kRate, noisy, noise(said, said));
      if (i > 100) squares += (pose.t - steady(i / kRate).t).squaredNorm() / 3;
    }
    return std::sqrt(squares / 300);
  };
  EXPECT_LT(error(kSigma / 3), 0.6 * kSigma);
  EXPECT_GT(error(kSigma / 30), 0.9 * kSigma);  // within reason
}

TEST(MotionFilter, TakesWhatIsMeasuredWhereTheMotionIsLarge) {
  MotionFilter filter(true);
  filter.start(0, {});
  std::mt19937 random(5);
  for (int i = 1; i <= 60; ++i) {
    const Pose pose{so3_exp(draw(random, 0.05)), draw(random, 0.05)};
    const Pose believed = filter.update(i / kRate, pose, noise(1e-4, 1e-4));
    if (i > 3) {
      EXPECT_LT((believed.t - pose.t).norm(), 2e-3);
    }
  }
}

TEST(MotionFilter, WithoutShrinkingGivesWhatItIsGiven) {
  MotionFilter filter(false);
  filter.start(0, {});
  std::mt19937 random(6);
  for (int i = 1; i <= 20; ++i) {
    const Pose pose{so3_exp(draw(random, 0.01)), draw(random, 0.01)};
    EXPECT_LT((filter.update(i / kRate, pose, noise(1, 1)).matrix() - pose.matrix()).norm(), 1e-12);
  }
}

// How far a camera comes in a second without measurements, as a share of what its last velocity would take
// it.
double share_of_steady(const std::function<double(double)>& position) {
  MotionFilter filter(false);
  filter.start(0, {});
  double last = 0;
  for (int i = 1; i <= 240; ++i) {
    filter.update(i / kRate, {Eigen::Matrix3d::Identity(), {position(i / kRate), 0, 0}}, noise(1e-9, 1e-9));
    last = i / kRate;
  }
  const double velocity = (position(last) - position(last - 1 / kRate)) * kRate;
  for (int i = 1; i <= kRate; ++i) filter.coast(last + i / kRate);
  return (filter.predict(last + 1).t.x() - position(last)) / velocity;
}

TEST(MotionFilter, CoastsAsFarAsItsMotionUsedToLast) {
  EXPECT_GT(share_of_steady([](double t) { return 8 * t; }), 0.9);                  // a car
  EXPECT_LT(share_of_steady([](double t) { return 0.1 * std::sin(5 * t); }), 0.5);  // a hand
}

TEST(MotionFilter, CoastsEverSlower) {
  MotionFilter filter(true);
  filter.start(0, steady(0));
  for (int i = 1; i <= 10; ++i) filter.update(i / kRate, steady(i / kRate), noise(1e-9, 1e-9));
  for (int i = 11; i <= 300; ++i) filter.coast(i / kRate);
  const Pose late = filter.predict(10), later = filter.predict(11);
  EXPECT_LT((late.t - later.t).norm(), 1e-6);
  EXPECT_LT((late.t - steady(10 / kRate).t).norm(), 0.2);
}

TEST(MotionFilter, ACameraThatTurnsTurnsWhileDepthIsLate) {
  MotionFilter filter(true);
  filter.start(0, steady(0));
  for (int i = 1; i <= 10; ++i) filter.update(i / kRate, steady(i / kRate), noise(1e-9, 1e-9));
  const Pose expected = steady(10 / kRate + 0.01).inverse() * steady(10 / kRate);
  const Pose found = filter.motion_during(0.01);
  EXPECT_LT(rotation_angle(found.R.transpose() * expected.R), 1e-6);
  EXPECT_LT((found.t - expected.t).norm(), 1e-6);
}

}  // namespace
}  // namespace framewise
