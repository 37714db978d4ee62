// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/first_pair_scale.h"

#include <gtest/gtest.h>

namespace framewise {
namespace {

Step step(Status status, std::optional<double> length = {}) {
  Step step;
  step.status = status;
  step.length_from_depth = length;
  step.cam2_from_cam1.t =
      status == Status::kRotationOnly ? Eigen::Vector3d::Zero().eval() : Eigen::Vector3d(0, 0.6, 0.8);
  step.covariance = Matrix6d::Identity();
  return step;
}

TEST(FirstPairScale, TheFirstMeasuredTranslationFixesTheLengthOfAll) {
  FirstPairScale scale;
  const Step first = scale.apply(step(Status::kOk, 0.25));
  EXPECT_NEAR(first.cam2_from_cam1.t.norm(), 0.25, 1e-15);
  EXPECT_NEAR(first.covariance(5, 5), 0.0625, 1e-15);
  EXPECT_EQ(first.covariance(0, 0), 1);
  const Step second = scale.apply(step(Status::kLowParallax, 3.0));
  EXPECT_NEAR(second.cam2_from_cam1.t.norm(), 0.25, 1e-15);
  EXPECT_EQ(second.status, Status::kLowParallax);
  EXPECT_EQ(scale.length(), 0.25);
}

TEST(FirstPairScale, WhatComesBeforeOnlyTurnedOrHasNoLength) {
  FirstPairScale scale;
  EXPECT_EQ(scale.apply(step(Status::kOk)).status, Status::kNoDepth);  // no depth there
  const Step uncertain = scale.apply(step(Status::kLowParallax, 0.5));
  EXPECT_EQ(uncertain.status, Status::kRotationOnly);
  EXPECT_EQ(uncertain.cam2_from_cam1.t.norm(), 0);
  EXPECT_TRUE(std::isnan(uncertain.covariance(5, 5)));
  EXPECT_EQ(scale.apply(step(Status::kRotationOnly)).status, Status::kRotationOnly);
  EXPECT_EQ(scale.apply(step(Status::kLost)).status, Status::kLost);
  EXPECT_FALSE(scale.length());
  EXPECT_EQ(scale.apply(step(Status::kOk, 0.1)).status, Status::kOk);
}

}  // namespace
}  // namespace framewise
