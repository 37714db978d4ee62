// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/keyframe_choice.h"

#include <gtest/gtest.h>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr int kWidth = 640;

TEST(WantsKeyframe, WhereTooLittleIsLeftOfWhatTheNewestSaw) {
  MapOptions options;
  options.keyframe_share = 0.7;
  EXPECT_FALSE(wants_keyframe({70, 100, false, {}}, kWidth, options));
  EXPECT_TRUE(wants_keyframe({69, 100, false, {}}, kWidth, options));
  EXPECT_TRUE(wants_keyframe({69, 100, true, 0.0}, kWidth, options));
}

TEST(WantsKeyframe, WithoutDepthWhereTheCameraHasMoved) {
  MapOptions options;
  options.keyframe_shift = 0.01;
  EXPECT_FALSE(wants_keyframe({100, 100, true, 6.3}, kWidth, options));
  EXPECT_TRUE(wants_keyframe({100, 100, true, 6.5}, kWidth, options));
  EXPECT_FALSE(wants_keyframe({100, 100, false, 6.5}, kWidth, options));
}

TEST(WantsKeyframe, WithoutDepthWhereNothingTellsHowFarItMoved) {
  EXPECT_TRUE(wants_keyframe({100, 100, true, {}}, kWidth, {}));
}

TEST(NeedsAdjustment, WithDepthWhereEachFrameIsAKeyframeAndMoves) {
  MapOptions options;
  options.keyframe_shift = 0.01;
  const KeyframeNeed moved{50, 100, false, 6.5}, turned{50, 100, false, 6.3};
  EXPECT_TRUE(needs_adjustment(moved, true, kWidth, options));
  EXPECT_FALSE(needs_adjustment(moved, false, kWidth, options));
  EXPECT_FALSE(needs_adjustment(turned, true, kWidth, options));
  EXPECT_FALSE(needs_adjustment({50, 100, false, {}}, true, kWidth, options));
  options.adjust = "never";
  EXPECT_FALSE(needs_adjustment(moved, true, kWidth, options));
  options.adjust = "always";
  EXPECT_TRUE(needs_adjustment(turned, false, kWidth, options));
}

TEST(NeedsAdjustment, AlwaysWhereNoDepthTellsHowFarThingsAre) {
  MapOptions options;
  options.adjust = "never";
  EXPECT_TRUE(needs_adjustment({50, 100, true, {}}, false, kWidth, options));
}

const std::vector<Eigen::Vector3d> kPoints = {{0.5, 0.2, 2}, {-0.3, 0.1, 2}, {0.1, -0.4, 2}};

TEST(MedianShift, IsThatOfMotionOverDepth) {
  const auto shift = median_shift(kPoints, {}, {Eigen::Matrix3d::Identity(), {0.1, 0, 0}});
  ASSERT_TRUE(shift);
  EXPECT_NEAR(*shift, 0.1 / 2, 1e-12);
}

TEST(MedianShift, ATurnIsNone) {
  const auto shift = median_shift(kPoints, {}, {so3_exp({0.1, 0.2, -0.3}), {0, 0, 0}});
  ASSERT_TRUE(shift);
  EXPECT_NEAR(*shift, 0, 1e-12);
}

TEST(MedianShift, DoesNotDependOnTheWorld) {
  const Pose world{so3_exp({1, -2, 0.5}), {10, 20, -30}}, moved{so3_exp({0.1, 0, 0}), {0.1, 0.05, 0.02}};
  EXPECT_NEAR(*median_shift(kPoints, world, world * moved), *median_shift(kPoints, {}, moved), 1e-9);
}

TEST(MedianShift, WhatIsBehindEitherCameraTellsNothing) {
  EXPECT_FALSE(median_shift({}, {}, {}));
  EXPECT_FALSE(median_shift({{0, 0, -1}}, {}, {}));
  EXPECT_FALSE(median_shift(kPoints, {}, {Eigen::Matrix3d::Identity(), {0, 0, 3}}));
}

}  // namespace
}  // namespace framewise
