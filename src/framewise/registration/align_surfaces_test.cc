// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/align_surfaces.h"

#include <gtest/gtest.h>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/registration/alignment_kernels.h"
#include "framewise/registration/scenes_for_tests.h"

namespace framewise {
namespace {

using testing::depth_of;
using testing::furnished_room;
using testing::small_motion;
using testing::test_camera;
using testing::TestScene;
using testing::with_noise;

double rotation_error(const Pose& a, const Pose& b) { return rotation_angle(a.R.transpose() * b.R); }

SurfacePyramid seen(const TestScene& scene, const Pose& world_from_cam) {
  return SurfaceMaker(test_camera(), {})(depth_of(scene, test_camera(), world_from_cam));
}

std::optional<SurfaceAlignment> aligned(const TestScene& scene, const Pose& cam2_from_cam1,
                                        const Pose& guess = {}) {
  return align_surfaces(seen(scene, Pose()), seen(scene, cam2_from_cam1.inverse()), guess, {});
}

TEST(AlignSurfaces, RecoversAKnownMotionFromIdentity) {
  for (const double scale : {0.0, 0.1, 1.0, 2.0}) {
    const Pose motion = small_motion(scale);
    const auto found = aligned(furnished_room(), motion);
    ASSERT_TRUE(found);
    EXPECT_LT(rotation_error(found->cam2_from_cam1, motion), 3e-4) << scale;
    EXPECT_LT((found->cam2_from_cam1.t - motion.t).norm(), 1e-3) << scale;
    EXPECT_TRUE(found->free_directions.empty());
  }
}

TEST(AlignSurfaces, RecoversALargeMotionFromANearGuess) {
  const Pose motion = small_motion(8);
  const auto found = aligned(furnished_room(), motion, small_motion(7));
  ASSERT_TRUE(found);
  EXPECT_LT(rotation_error(found->cam2_from_cam1, motion), 5e-4);
  EXPECT_LT((found->cam2_from_cam1.t - motion.t).norm(), 2e-3);
}

// d (sum e^2 / 2) / d (omega, tau) by the kernel's columns and by differences.
TEST(AlignmentKernel, GradientIsThatOfTheSquares) {
  const Surface reference = seen(furnished_room(), Pose())[0];
  const Surface current = seen(furnished_room(), small_motion(1))[0];
  const auto view = [](const Surface& s) {
    return SurfaceView{s.grid.width,      s.grid.height,          s.grid.fx,   s.grid.fy,   s.grid.cx,
                       s.grid.cy,         s.inverse_depth.data(), s.nx.data(), s.ny.data(), s.nz.data(),
                       s.distance.data(), s.precision.data()};
  };
  std::vector<float> scratch(pull_scratch(reference.grid.width));
  const auto sums = [&](const Vector6d& step) {
    const Eigen::Matrix3d R = so3_exp(step.head<3>());
    MotionView motion{};
    for (int i = 0; i < 9; ++i) motion.R[i] = static_cast<float>(R(i / 3, i % 3));
    for (int i = 0; i < 3; ++i) motion.t[i] = static_cast<float>(step[3 + i]);
    PullSums result{};
    for (int v = 0; v < current.grid.height; ++v)
      add_pull_of_row(view(reference), view(current), v, motion, {PullLoss::kTrivial, 1e6f, 1, 0.1f, 0.9f},
                      scratch.data(), result);
    return result;
  };
  const PullSums here = sums(Vector6d::Zero());
  int at = 0;
  for (int i = 0; i < 6; ++i) {
    at += 6 - i;  // the product with the residual is the last of its row
    const double h = 2e-4;
    const double higher = sums(h * Vector6d::Unit(i)).products[kPullProducts - 1];
    const double lower = sums(-h * Vector6d::Unit(i)).products[kPullProducts - 1];
    const double scale = std::sqrt(here.products[kPullProducts - 1] * here.partners) * 100;
    EXPECT_NEAR((higher - lower) / (4 * h), here.products[at],
                0.03 * std::abs(here.products[at]) + 0.01 * scale);
    ++at;
  }
}

TEST(AlignSurfaces, LeavesFreeWhatAPlaneDoesNotShow) {
  const TestScene plane{{{{0, 0, 1}, 2.0}}, {}};
  const auto found = aligned(plane, Pose{Eigen::Matrix3d::Identity(), {0.0, 0.0, 0.01}});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->free_directions.size(), 3u);
  for (const FreeDirection& direction : found->free_directions) {
    EXPECT_LT(std::abs(direction.translation.z()), 0.05) << name_of(direction);
    EXPECT_LT(direction.rotation.head<2>().norm(), 0.1 * (1 + std::abs(direction.rotation.z())));
  }
  EXPECT_NEAR(found->cam2_from_cam1.t.z(), 0.01, 1e-4);
  EXPECT_TRUE(std::isnan(found->covariance(0, 0)));
}

TEST(AlignSurfaces, KeepsTheGuessAlongACorridorAndMeasuresTheRest) {
  const TestScene corridor{{{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1.2}, {{0, -1, 0}, 1.2}}, {}};
  const Pose motion{so3_exp({0.005, 0.01, 0}), {0.01, -0.01, 0.03}};
  const auto found = aligned(corridor, motion, Pose{Eigen::Matrix3d::Identity(), {0, 0, 0.02}});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->free_directions.size(), 1u);
  const FreeDirection& direction = found->free_directions[0];
  EXPECT_TRUE(direction.is_translation());
  EXPECT_GT(std::abs(direction.translation.z()), 0.99) << name_of(direction);
  EXPECT_NEAR(found->cam2_from_cam1.t.z(), 0.02, 2e-3);
  EXPECT_LT((found->cam2_from_cam1.t - motion.t).head<2>().norm(), 2e-3);
  EXPECT_LT(rotation_error(found->cam2_from_cam1, motion), 1e-3);
}

TEST(AlignSurfaces, LeavesATurnAboutABallFree) {
  const TestScene ball{{}, {{{0, 0, 2}, 0.9}}};
  const auto found = aligned(ball, Pose());
  ASSERT_TRUE(found);
  ASSERT_EQ(found->free_directions.size(), 3u);
  for (const FreeDirection& direction : found->free_directions) {
    // The motion of the ball's centre.
    const Eigen::Vector3d arm = Eigen::Vector3d(0, 0, 2) - direction.centre;
    EXPECT_LT((direction.translation + direction.rotation.cross(arm)).norm(), 0.1) << name_of(direction);
  }
}

TEST(AlignSurfaces, ErrorsAreWhatTheCovarianceSays) {
  std::mt19937_64 random(1);
  const DepthNoise noise;
  const Camera camera = test_camera();
  SurfaceOptions surface;
  surface.sideways_px = 0.01;  // there is none in these images
  const SurfaceMaker maker(camera, surface);
  AlignmentOptions options;
  // Each pixel of the image has its own noise, and four are one of the finest level: 0.25, were there no
  // edges, where the neighbourhoods are cut and half of what is known is lost.
  options.noise_area_px = 0.5;
  const Pose motion = small_motion(0.3);
  const cv::Mat depth1 = depth_of(furnished_room(), camera, Pose());
  const cv::Mat depth2 = depth_of(furnished_room(), camera, motion.inverse());
  double nees = 0;
  constexpr int kTrials = 40;
  for (int k = 0; k < kTrials; ++k) {
    const auto found = align_surfaces(maker(with_noise(depth1, noise, random)),
                                      maker(with_noise(depth2, noise, random)), motion, options);
    ASSERT_TRUE(found);
    Vector6d error;
    error << so3_log(motion.R.transpose() * found->cam2_from_cam1.R), found->cam2_from_cam1.t - motion.t;
    nees += error.dot(Cholesky<6>(found->covariance).solve(error)) / kTrials;
  }
  // Six degrees of freedom; the planes' rounded edges and the loss cost a little.
  EXPECT_GT(nees, 2);
  EXPECT_LT(nees, 12);
}

TEST(AlignSurfaces, SaysNothingWhereThereIsNothing) {
  const SurfacePyramid room = seen(furnished_room(), Pose());
  const Camera camera = test_camera();
  const SurfacePyramid dark =
      SurfaceMaker(camera, {})(cv::Mat(camera.height, camera.width, CV_32F, cv::Scalar(std::nanf(""))));
  EXPECT_FALSE(align_surfaces(room, dark, Pose(), {}));
  EXPECT_FALSE(align_surfaces(dark, room, Pose(), {}));
  EXPECT_FALSE(align_surfaces({}, room, Pose(), {}));
  EXPECT_FALSE(align_surfaces(room, room, Pose{Eigen::Matrix3d::Identity(), {0, 0, 50}}, {}));
}

TEST(AlignmentOptions, NameWhatIsWrong) {
  AlignmentOptions options;
  options.widening = 0;
  try {
    options.check();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("widening"), std::string::npos);
  }
}

}  // namespace
}  // namespace framewise
