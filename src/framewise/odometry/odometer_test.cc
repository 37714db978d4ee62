// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/odometer.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// A camera that slides along a wall with a random pattern, 2 m away; the wall's depth is exact.
class Wall {
 public:
  static constexpr double kDepth = 2, kFocal = 200, kStepPx = 4;

  Wall() {
    cv::Mat coarse(40, 120, CV_8U);
    cv::RNG rng(5);
    rng.fill(coarse, cv::RNG::UNIFORM, 0, 256);
    cv::resize(coarse, wall_, {}, 8, 8, cv::INTER_NEAREST);
  }

  Camera camera() const { return {CameraModel::kPinhole, 320, 240, kFocal, kFocal, 159.5, 119.5}; }

  Frame frame(std::size_t index) const {
    Frame frame;
    frame.time = 0.1 * static_cast<double>(index);
    frame.gray = wall_(cv::Rect(static_cast<int>(kStepPx * index), 40, 320, 240)).clone();
    frame.depth = cv::Mat(frame.gray.size(), CV_32F, cv::Scalar(kDepth));
    return frame;
  }

  FrameSource source(std::size_t size) const {
    return {size, [this](std::size_t i) { return frame(i); }, nullptr};
  }

 private:
  cv::Mat wall_;
};

std::vector<FrameResult> run(const FrameSource& source, const Camera& camera,
                             const OdometryOptions& options) {
  std::vector<FrameResult> results;
  run_odometry(
      source, camera, options, [] { return 0.0; }, [&](const FrameResult& r) { results.push_back(r); });
  return results;
}

TEST(RunOdometry, MeasuresAKnownMotionInMetres) {
  const Wall wall;
  const auto results = run(wall.source(10), wall.camera(), {});
  ASSERT_EQ(results.size(), 10u);
  for (const FrameResult& result : results) {
    EXPECT_EQ(result.step.status, Status::kOk);
    const Eigen::Vector3d expected(Wall::kStepPx / Wall::kFocal * Wall::kDepth * result.index, 0, 0);
    EXPECT_LT((result.world_from_cam.t - expected).norm(), 1e-4 + 4e-3 * expected.norm()) << result.index;
    EXPECT_LT(rotation_angle(result.world_from_cam.R), 1e-4 + 2e-4 * result.index);
  }
}

TEST(RunOdometry, IsTheSameAtAnyThreadCount) {
  const Wall wall;
  OdometryOptions options;
  options.threads = 1;
  const auto expected = run(wall.source(12), wall.camera(), options);
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    const auto results = run(wall.source(12), wall.camera(), options);
    ASSERT_EQ(results.size(), expected.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_EQ(results[i].index, i);
      EXPECT_EQ(results[i].world_from_cam.matrix(), expected[i].world_from_cam.matrix());
    }
  }
}

TEST(RunOdometry, AStandingCameraStands) {
  const Wall wall;
  FrameSource source = wall.source(5);
  source.load = [&](std::size_t) { return wall.frame(3); };
  for (const FrameResult& result : run(source, wall.camera(), {}))
    EXPECT_LT(result.world_from_cam.t.norm(), 1e-12);
}

TEST(RunOdometry, HandsOverWhatCameBeforeAFailure) {
  const Wall wall;
  FrameSource source = wall.source(20);
  source.load = [&](std::size_t i) {
    if (i == 11) throw std::runtime_error("frame 11 is broken");
    return wall.frame(i);
  };
  std::vector<std::size_t> seen;
  EXPECT_THROW(run_odometry(
                   source, wall.camera(), {}, [] { return 0.0; },
                   [&](const FrameResult& result) { seen.push_back(result.index); }),
               std::runtime_error);
  ASSERT_EQ(seen.size(), 11u);
  EXPECT_EQ(seen.back(), 10u);
}

TEST(RunOdometry, SaysNoDepthWhereThereIsNone) {
  const Wall wall;
  FrameSource source = wall.source(4);
  source.load = [&](std::size_t i) {
    Frame frame = wall.frame(i);
    if (i == 2) frame.depth.release();
    if (i == 3) frame.depth = std::numeric_limits<float>::quiet_NaN();
    return frame;
  };
  const auto results = run(source, wall.camera(), {});
  EXPECT_EQ(results[1].step.status, Status::kOk);
  EXPECT_EQ(results[2].step.status, Status::kNoDepth);
  EXPECT_EQ(results[3].step.status, Status::kNoDepth);
  EXPECT_EQ(results[3].world_from_cam.matrix(), results[1].world_from_cam.matrix());
}

TEST(RunOdometry, NoFramesGiveNoResults) {
  const Wall wall;
  EXPECT_TRUE(run(wall.source(0), wall.camera(), {}).empty());
}

TEST(OdometryOptions, NameTheBadValue) {
  OdometryOptions options;
  options.solver = "magic";
  try {
    options.check();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "solver: found 'magic', expected one of kabsch, eight-point, seven-point, nister-5pt, "
                 "stewenius-5pt, kneip-5pt-rotation, eigensolver");
  }
  options = {};
  options.scale = "none";
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
