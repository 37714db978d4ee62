// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/frame_pair.h"

#include <gtest/gtest.h>

#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

const FramePairOptions kOptions;

FrameView view_of(const Frame& frame) { return FrameView(look_at(frame, 0)); }

// 0.4 m aside and rolled by 23 degrees: nothing is where it was.
const Pose kFar{so3_exp({0.02, -0.1, 0.4}), {0.4, 0.1, 0.05}};

TEST(PoseFromPair, FindsAMotionThatNothingForetells) {
  const Boxes boxes;
  FrameView first = view_of(boxes.frame({}, 0)), second = view_of(boxes.frame(kFar, 0.1));
  const auto found = pose_from_pair(first, second, {}, Boxes::camera(), kOptions);
  ASSERT_TRUE(found);
  const Pose world_from_cam = found->cam_from_reference.inverse();
  EXPECT_LT((world_from_cam.t - kFar.t).norm(), 0.01);
  EXPECT_LT(rotation_angle(world_from_cam.R.transpose() * kFar.R), 0.005);
  EXPECT_TRUE(found->covariance.allFinite());
}

TEST(PoseFromPair, TheSecondFrameNeedsNoDepth) {
  const Boxes boxes;
  Frame seen = boxes.frame(kFar, 0.1);
  seen.depth.release();
  FrameView first = view_of(boxes.frame({}, 0)), second = view_of(seen);
  EXPECT_TRUE(pose_from_pair(first, second, {}, Boxes::camera(), kOptions));
  EXPECT_FALSE(pose_from_pair(second, first, {}, Boxes::camera(), kOptions));
}

TEST(PoseFromPair, WhatHasNothingInCommonHasNoPose) {
  const Boxes boxes;
  FrameView first = view_of(boxes.frame({}, 0));
  Frame other = boxes.frame({}, 0.1);
  cv::RNG(5).fill(other.gray, cv::RNG::UNIFORM, 0, 256);
  FrameView noise = view_of(other), nothing;
  EXPECT_FALSE(pose_from_pair(first, noise, {}, Boxes::camera(), kOptions));
  EXPECT_FALSE(pose_from_pair(first, nothing, {}, Boxes::camera(), kOptions));
  other.gray = cv::Scalar(128);
  FrameView wall = view_of(other);
  EXPECT_FALSE(pose_from_pair(first, wall, {}, Boxes::camera(), kOptions));
}

}  // namespace
}  // namespace framewise
