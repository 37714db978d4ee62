// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/surface_model.h"

#include <gtest/gtest.h>

#include "framewise/registration/scenes_for_tests.h"

namespace framewise {
namespace {

using testing::depth_of;
using testing::furnished_room;
using testing::small_motion;
using testing::test_camera;
using testing::with_noise;

TEST(SurfaceModel, KnowsThePoseBetterThanAChainOfSteps) {
  std::mt19937_64 random(2);
  const Camera camera = test_camera();
  const SurfaceMaker maker(camera, {});
  SurfaceModel model(maker, {}, {});
  SurfacePyramid previous;
  Pose chained, last_truth;
  double model_error = 0, chain_error = 0;
  for (int k = 0; k < 40; ++k) {
    const Pose truth = small_motion(0.8 * std::sin(0.3 * k));
    const SurfacePyramid frame =
        maker(with_noise(depth_of(furnished_room(), camera, truth), DepthNoise{0.004, 0.006, 0.4}, random));
    if (k == 0) {
      model.start(frame, truth);
      chained = truth;
    } else {
      const auto step = align_surfaces(previous, frame, Pose(), {});
      const auto found = model.align(frame, last_truth);
      ASSERT_TRUE(step && found);
      chained = chained * step->cam2_from_cam1.inverse();
      const Pose pose = model.world_from_keyframe() * found->cam2_from_cam1.inverse();
      model.add(frame, pose, found->overlap);
      model_error += (pose.t - truth.t).norm();
      chain_error += (chained.t - truth.t).norm();
    }
    previous = frame;
    last_truth = truth;
  }
  EXPECT_EQ(model.keyframes(), 1u);
  EXPECT_LT(model_error, 0.8 * chain_error);
}

TEST(SurfaceModel, BeginsAnewWhereTheViewHasMovedOn) {
  const Camera camera = test_camera();
  const SurfaceMaker maker(camera, {});
  SurfaceModel model(maker, {}, {});
  EXPECT_FALSE(model.is_started());
  model.start(maker(depth_of(furnished_room(), camera, Pose())), Pose());
  const Pose away = small_motion(5);
  model.add(maker(depth_of(furnished_room(), camera, away)), away, 0.9);
  EXPECT_EQ(model.keyframes(), 2u);
  EXPECT_EQ(model.world_from_keyframe().t, away.t);
}

}  // namespace
}  // namespace framewise
