// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/view_pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

// Half a metre aside and rolled by 23 degrees: nothing is where it was.
const Pose kWide{so3_exp({0.02, -0.1, 0.4}), {0.4, 0.1, 0.05}};

struct TwoFrames {
  Frame frame1, frame2;
  FrameView first, second;

  explicit TwoFrames(const Pose& world_from_cam2) {
    static const Boxes boxes;
    frame1 = boxes.frame({}, 0), frame2 = boxes.frame(world_from_cam2, 0.1);
    first = blind(frame1), second = blind(frame2);
  }

  static FrameView blind(Frame frame) {
    frame.depth.release();
    return FrameView(look_at(frame, 0));
  }

  // As a map of that unit would have them: of some features of the first frame.
  std::vector<KnownDepth> known(double unit) {
    std::vector<KnownDepth> depths;
    const MapFrame& frame = first.described(Boxes::camera());
    for (int i = 0; i < static_cast<int>(frame.rays.size()); i += 7) {
      const Eigen::Vector2d pixel = frame.pixel(i);
      const double z = frame1.depth.at<float>(static_cast<int>(pixel.y()), static_cast<int>(pixel.x()));
      if (std::isfinite(z)) depths.push_back({pixel, z * unit, 0.02});
    }
    return depths;
  }

  std::optional<ViewPose> pose(const std::vector<KnownDepth>& depths, const Pose& prior = {}) {
    return pose_from_views(first, second, prior, depths, Boxes::camera(), {});
  }
};

TEST(PoseFromViews, AMotionThatNothingForetellsHasTheUnitOfTheDepthsThatAreKnown) {
  TwoFrames frames(kWide);
  for (const double unit : {1.0, 3.7}) {
    const auto found = frames.pose(frames.known(unit));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->is_far);
    EXPECT_FALSE(found->is_guess);
    const Pose world_from_cam = found->pose.cam_from_reference.inverse();
    EXPECT_LT((world_from_cam.t / unit - kWide.t).norm(), 0.03);
    EXPECT_LT(rotation_angle(world_from_cam.R.transpose() * kWide.R), 0.01);
    EXPECT_TRUE(found->pose.covariance.allFinite());
  }
}

TEST(PoseFromViews, ATurnIsATurnAndInventsNoMotion) {
  const Pose turned{so3_exp({0.02, -0.2, 0.05}), {0, 0, 0}};
  TwoFrames frames(turned);
  const auto found = frames.pose(frames.known(1), {Eigen::Matrix3d::Identity(), {0.3, 0, 0}});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_far);
  EXPECT_LT(rotation_angle(found->pose.cam_from_reference.R * turned.R), 0.004);
  if (!found->is_guess) {
    EXPECT_LT(found->pose.cam_from_reference.t.norm(), 0.02);
  }
}

TEST(PoseFromViews, WithoutAKnownDepthTheLengthIsThePriorsAndSaidToBeAGuess) {
  TwoFrames frames(kWide);
  const Pose prior{Eigen::Matrix3d::Identity(), {0, 0, -0.7}};
  const auto found = frames.pose({}, prior);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_guess);
  EXPECT_NEAR(found->pose.cam_from_reference.t.norm(), 0.7, 1e-9);
  const Pose expected = kWide.inverse();
  EXPECT_GT(found->pose.cam_from_reference.t.normalized().dot(expected.t.normalized()), 0.99);
}

TEST(PoseFromViews, WhatHasNothingInCommonHasNoPose) {
  TwoFrames frames(kWide);
  const auto depths = frames.known(1);
  Frame noise = frames.frame2;
  cv::RNG(5).fill(noise.gray, cv::RNG::UNIFORM, 0, 256);
  frames.second = TwoFrames::blind(noise);
  EXPECT_FALSE(frames.pose(depths));
  frames.second = FrameView();
  EXPECT_FALSE(frames.pose(depths));
}

// A triangulated motion of length 1 whose points are at depth 2, seen at (20 i, 0).
struct Triangulated {
  TwoViewStart two_views;
  MapFrame frame1;
  std::vector<KnownDepth> known;

  explicit Triangulated(int count) {
    for (int i = 0; i < count; ++i) {
      frame1.features.keypoints.emplace_back(20.0f * static_cast<float>(i), 0.0f, 7.0f);
      MapPoint point{};
      point.feature = i;
      point.ray = {0, 0, 1};
      point.inverse_z = 0.5;
      point.variance = 1e-4;
      two_views.points.push_back(point);
      known.push_back({{20.0 * i + 1, 1}, 6.0, 0.01});
    }
  }
};

TEST(LengthByKnown, IsThatOfMostPointsWhateverSomeSay) {
  Triangulated scene(40);
  for (int i = 0; i < 40; i += 3) scene.known[i].z = 25;
  const auto length = length_by_known(scene.two_views, scene.frame1, scene.known);
  ASSERT_TRUE(length);
  EXPECT_NEAR(length->value, 3, 0.03);
  EXPECT_LT(length->relative_sigma, 0.05);
}

TEST(LengthByKnown, IsEmptyWhereFewAreKnownOrNoneIsNearOrTheyDisagree) {
  EXPECT_FALSE(length_by_known(Triangulated(9).two_views, Triangulated(9).frame1, Triangulated(9).known));
  Triangulated beside(40), uncertain(40), scattered(40);
  for (KnownDepth& depth : beside.known) depth.pixel.y() = 5;
  EXPECT_FALSE(length_by_known(beside.two_views, beside.frame1, beside.known));
  for (KnownDepth& depth : uncertain.known) depth.relative_sigma = 0.5;
  EXPECT_FALSE(length_by_known(uncertain.two_views, uncertain.frame1, uncertain.known));
  for (int i = 0; i < 40; ++i) scattered.known[i].z = std::exp(0.1 * i);
  EXPECT_FALSE(length_by_known(scattered.two_views, scattered.frame1, scattered.known));
}

// Two views whose rotation is known, and points of camera 1 that camera 2 sees after a motion by t.
struct Turned {
  TwoViewStart two_views;
  MapFrame frame1;
  std::vector<KnownDepth> known;
  Eigen::Vector3d t{0.1, -0.05, 0.45};

  explicit Turned(int count) {
    two_views.cam2_from_cam1.R = so3_exp({0.02, -0.06, 0.03});
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d pixel(20 + 37 * i % 280, 15 + 53 * i % 210);
      const double z = 2 + 0.13 * (7 * i % 31);
      frame1.features.keypoints.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()),
                                             7.0f);
      frame1.rays.push_back({(pixel.x() - 159.5) / 250, (pixel.y() - 119.5) / 250, 1});
      known.push_back({pixel, z, 1e-3});
      const Eigen::Vector3d x = two_views.cam2_from_cam1.R * (z * frame1.rays.back()) + t;
      two_views.agreeing.push_back({i, i, pixel, x / x.z(), {}});
    }
  }

  std::optional<KnownTranslation> translation() const {
    return translation_by_known(two_views, frame1, known, Boxes::camera(), 1);
  }
};

TEST(TranslationByKnown, IsExactWhateverSomeRaysSay) {
  Turned scene(30);
  for (int i = 0; i < 30; i += 3) scene.two_views.agreeing[i].ray2.x() += 0.1;
  const auto found = scene.translation();
  ASSERT_TRUE(found);
  EXPECT_LT((found->t - scene.t).norm(), 1e-12);
  EXPECT_GT(found->covariance.determinant(), 0);
}

TEST(TranslationByKnown, FollowsTheRotationAsItsDerivativeSays) {
  Turned scene(30);
  const auto found = scene.translation();
  ASSERT_TRUE(found);
  const Eigen::Matrix3d R = scene.two_views.cam2_from_cam1.R;
  constexpr double kStep = 1e-5;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d turn = kStep * Eigen::Vector3d::Unit(axis);
    scene.two_views.cam2_from_cam1.R = R * so3_exp(turn);
    const auto more = scene.translation();
    scene.two_views.cam2_from_cam1.R = R * so3_exp(-turn);
    const auto less = scene.translation();
    ASSERT_TRUE(more && less);
    EXPECT_LT(((more->t - less->t) / (2 * kStep) - found->by_rotation.col(axis)).norm(), 1e-3);
  }
}

TEST(TranslationByKnown, IsEmptyWhereFewAgree) {
  EXPECT_FALSE(Turned(9).translation());
  Turned scattered(30);
  for (int i = 0; i < 30; ++i) scattered.known[i].z *= 1 + 0.4 * (i % 7);
  EXPECT_FALSE(scattered.translation());
}

TEST(KnownDepths, AreThoseThatTheCameraSeesAndTheMapIsSureOf) {
  LocalMap map(3);
  Keyframe& keyframe = map.add(std::make_shared<MapFrame>(), {});
  for (const double relative_sigma : {0.05, 0.5}) {
    MapPoint point{};
    point.ray = {0.1, 0, 1};
    point.inverse_z = 0.5;
    point.variance = std::pow(relative_sigma * point.inverse_z, 2);
    keyframe.points.push_back(point);
  }
  const Pose forward{Eigen::Matrix3d::Identity(), {0, 0, 0.5}};
  const auto known = known_depths(map, {0}, forward, Boxes::camera());
  ASSERT_EQ(known.size(), 1u);
  EXPECT_NEAR(known[0].z, 1.5, 1e-12);
  EXPECT_NEAR(known[0].relative_sigma, 0.05, 1e-12);
  EXPECT_NEAR(known[0].pixel.x(), 159.5 + 250 * 0.2 / 1.5, 1e-9);
  const Pose away{so3_exp({0, M_PI, 0}), {0, 0, 0}};
  EXPECT_TRUE(known_depths(map, {0}, away, Boxes::camera()).empty());
}

}  // namespace
}  // namespace framewise
