// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/geometric_refinement.h"

#include <gtest/gtest.h>

#include "framewise/registration/scenes_for_tests.h"

namespace framewise {
namespace {

using testing::depth_of;
using testing::furnished_room;
using testing::small_motion;
using testing::test_camera;
using testing::TestScene;

OdometryOptions by(const std::string& geometry) {
  OdometryOptions options;
  options.input = "normal";
  options.geometry = geometry;
  return options;
}

class Walk {
 public:
  Walk(const TestScene& scene, const std::string& geometry)
      : scene_(scene), refinement_(test_camera(), by(geometry)) {}

  Step see(const Pose& world_from_cam) { return see(depth_of(scene_, test_camera(), world_from_cam)); }
  Step see(const cv::Mat& depth) {
    const auto surface = std::make_shared<const SurfacePyramid>(refinement_.surface(depth));
    const Step step = refinement_.refine(time_, surface, Step(), false);
    time_ += 0.1;
    if (is_measured(step.status)) world_from_cam = world_from_cam * step.cam2_from_cam1.inverse();
    return step;
  }

  Pose world_from_cam;

 private:
  TestScene scene_;
  GeometricRefinement refinement_;
  double time_ = 0;
};

TEST(GeometricRefinement, FollowsAMotionWithoutAnyFeature) {
  for (const std::string geometry : {"frame", "model"}) {
    Walk walk(furnished_room(), geometry);
    for (int k = 0; k <= 8; ++k) {
      const Step step = walk.see(small_motion(0.5 * k));
      if (k > 0) {
        EXPECT_EQ(step.status, Status::kOk) << geometry << k;
      }
    }
    EXPECT_LT((walk.world_from_cam.t - small_motion(4).t).norm(), 5e-3) << geometry;
  }
}

TEST(GeometricRefinement, ForetellsTheWayAlongACorridorAndSaysSo) {
  TestScene corridor{{{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1.2}, {{0, -1, 0}, 1.2}},
                     {{{0.3, 0.5, 2.0}, 0.3}}};  // until the ball is passed, all is seen
  Walk walk(corridor, "frame");
  const auto at = [](int k) { return Pose{Eigen::Matrix3d::Identity(), {0, 0, 0.03 * k}}; };
  for (int k = 0; k <= 5; ++k) walk.see(at(k));
  const double passed = walk.world_from_cam.t.z();
  EXPECT_NEAR(passed, 0.15, 1.2e-2);
  corridor.balls.clear();
  const Camera camera = test_camera();
  walk.see(depth_of(corridor, camera, at(6)));
  const Step step = walk.see(depth_of(corridor, camera, at(7)));
  EXPECT_EQ(step.status, Status::kLowParallax);
  ASSERT_EQ(step.free_directions.size(), 1u);
  EXPECT_NE(step.free_directions[0].find("translation"), std::string::npos);
  EXPECT_NEAR(walk.world_from_cam.t.z() - passed, 0.06, 1e-2);
}

TEST(GeometricRefinement, GoesOnFromTheLastGoodFrameAfterADarkOne) {
  Walk walk(furnished_room(), "model");
  const Camera camera = test_camera();
  walk.see(small_motion(0));
  walk.see(small_motion(0.5));
  EXPECT_EQ(walk.see(cv::Mat(camera.height, camera.width, CV_32F, cv::Scalar(std::nanf("")))).status,
            Status::kNoDepth);
  EXPECT_EQ(walk.see(small_motion(1.5)).status, Status::kOk);
  EXPECT_LT((walk.world_from_cam.t - small_motion(1.5).t).norm(), 4e-3);
}

TEST(GeometricRefinement, HasNoDepthInNothingAndSaturatedImages) {
  const Camera camera = test_camera();
  Walk walk(furnished_room(), "frame");
  walk.see(small_motion(0));
  EXPECT_EQ(walk.see(cv::Mat()).status, Status::kNoDepth);
  EXPECT_EQ(walk.see(cv::Mat(camera.height, camera.width, CV_32F, cv::Scalar(65.535))).status,
            Status::kNoDepth);
  EXPECT_EQ(walk.see(cv::Mat(camera.height, camera.width, CV_32F, cv::Scalar(0))).status, Status::kNoDepth);
}

}  // namespace
}  // namespace framewise
