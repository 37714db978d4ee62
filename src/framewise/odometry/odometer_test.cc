// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/odometer.h"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

const OdometryOptions kDefault;

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
    return {size, [this](std::size_t i) { return frame(i); }, {}};
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
  const auto results = run(wall.source(10), wall.camera(), kDefault);
  ASSERT_EQ(results.size(), 10u);
  for (const FrameResult& result : results) {
    EXPECT_EQ(result.step.status, Status::kOk);
    const Eigen::Vector3d expected(Wall::kStepPx / Wall::kFocal * Wall::kDepth * result.index, 0, 0);
    EXPECT_LT((result.world_from_cam.t - expected).norm(), 1e-4 + 4e-3 * expected.norm()) << result.index;
    EXPECT_LT(rotation_angle(result.world_from_cam.R), 1e-4 + 2e-4 * result.index);
  }
}

TEST(OdometryOptions, TheMatcherFollowsTheImageUnlessItIsNamed) {
  OdometryOptions options;
  for (const char* made_of_depth : {"depth", "depth-raw", "flexion", "flexion-published", "normal"})
    EXPECT_EQ(options.matcher_for(made_of_depth), "windowed") << made_of_depth;
  EXPECT_EQ(options.matcher_for("color"), "brute-force");
  EXPECT_EQ(options.matcher_for("auto"), "auto");  // one frame this, one frame that
  options.matcher = "flann";
  EXPECT_EQ(options.matcher_for("normal"), "flann");
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
  for (const FrameResult& result : run(source, wall.camera(), kDefault))
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
                   source, wall.camera(), kDefault, [] { return 0.0; },
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
  const auto results = run(source, wall.camera(), kDefault);
  EXPECT_EQ(results[1].step.status, Status::kOk);
  EXPECT_EQ(results[2].step.status, Status::kNoDepth);
  EXPECT_EQ(results[3].step.status, Status::kNoDepth);
  EXPECT_EQ(results[3].world_from_cam.matrix(), results[1].world_from_cam.matrix());
}

// The pairs of a run, and the run once more from them.
struct Replay {
  std::map<std::pair<std::size_t, std::size_t>, Correspondences> pairs;
  std::vector<std::pair<std::size_t, std::size_t>> order;
  std::vector<FrameResult> direct, replayed;
};

Replay replay(const FrameSource& source, const Camera& camera, OdometryOptions options,
              bool without_bridges = false) {
  Replay run;
  const auto clock = [] { return 0.0; };
  OdometryTaps taps;
  taps.pair = [&](std::size_t i, std::size_t j, const Correspondences& shared) {
    run.pairs[{i, j}] = shared;
    run.order.emplace_back(i, j);
  };
  run_odometry(
      source, camera, options, clock, [&](const FrameResult& r) { run.direct.push_back(r); }, taps);
  const PairSource pairs{source.size, [&](std::size_t i) { return run.direct[i].time; },
                         [&](std::size_t i, std::size_t j) -> std::optional<Correspondences> {
                           const auto found = run.pairs.find({i, j});
                           if (found == run.pairs.end() || (without_bridges && j - i > 1))
                             return std::nullopt;
                           return found->second;
                         },
                         source.known};
  options.threads = 1;
  run_odometry(pairs, camera, options, clock, [&](const FrameResult& r) { run.replayed.push_back(r); });
  return run;
}

// Frames 4 and 5 show nothing.
FrameSource with_a_loss(const Wall& wall) {
  FrameSource source = wall.source(9);
  source.load = [&](std::size_t i) {
    Frame frame = wall.frame(i);
    if (i == 4 || i == 5) frame.gray = cv::Scalar(90);
    return frame;
  };
  return source;
}

TEST(RunOdometry, CorrespondencesGiveWhatTheirImagesGave) {
  const Wall wall;
  for (const char* solver : {"kabsch", "nister-5pt"}) {
    OdometryOptions options;
    options.solver = solver;
    const Replay run = replay(with_a_loss(wall), wall.camera(), options);
    ASSERT_EQ(run.replayed.size(), run.direct.size());
    for (std::size_t i = 0; i < run.direct.size(); ++i) {
      const FrameResult &direct = run.direct[i], &replayed = run.replayed[i];
      EXPECT_EQ(replayed.time, direct.time);
      EXPECT_EQ(replayed.step.status, direct.step.status) << i;
      EXPECT_EQ(replayed.step.matches, direct.step.matches);
      EXPECT_EQ(replayed.world_from_cam.matrix(), direct.world_from_cam.matrix()) << i;
    }
  }
}

TEST(RunOdometry, HandsOverNeighboursAndBridgesInTheFramesOrder) {
  const Wall wall;
  using Order = std::vector<std::pair<std::size_t, std::size_t>>;
  const Order expected = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {3, 5}, {5, 6}, {3, 6}, {6, 7}, {7, 8}};
  for (const int threads : {1, 4}) {
    OdometryOptions options;
    options.threads = threads;
    EXPECT_EQ(replay(with_a_loss(wall), wall.camera(), options).order, expected);
  }
}

TEST(RunOdometry, AFrameIsLostWhereItsBridgeIsNotKnown) {
  const Wall wall;
  const Replay run = replay(with_a_loss(wall), wall.camera(), kDefault, true);
  EXPECT_EQ(run.direct[6].step.status, Status::kOk);
  EXPECT_EQ(run.replayed[6].step.status, Status::kLost);
  EXPECT_EQ(run.replayed[6].world_from_cam.matrix(), run.replayed[3].world_from_cam.matrix());
}

TEST(RunOdometry, HandsOverEveryFramesFeaturesInOrder) {
  const Wall wall;
  OdometryTaps taps;
  std::vector<std::size_t> seen;
  taps.features = [&](std::size_t index, const Features& features) {
    seen.push_back(index);
    EXPECT_EQ(features.descriptors.rows, static_cast<int>(features.keypoints.size()));
    EXPECT_GT(features.descriptors.rows, 100);
  };
  run_odometry(
      wall.source(5), wall.camera(), kDefault, [] { return 0.0; },
      [&](const FrameResult& result) { EXPECT_EQ(seen.back(), result.index); }, taps);
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(RunOdometry, TwoPointGoesWithTheRotationsItIsGiven) {
  const Wall wall;
  OdometryOptions options;
  options.solver = "two-point";
  options.scale = "centroid";
  FrameSource source = wall.source(6);
  EXPECT_THROW(run(source, wall.camera(), options), std::invalid_argument);
  source.known.rotation = [](std::size_t, std::size_t j) -> std::optional<Eigen::Matrix3d> {
    if (j == 5) return std::nullopt;  // the source ends
    return Eigen::Matrix3d::Identity();
  };
  const auto results = run(source, wall.camera(), options);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_EQ(results[i].step.status, Status::kOk);
    EXPECT_EQ(results[i].world_from_cam.R, Eigen::Matrix3d::Identity());
  }
  EXPECT_EQ(results[5].step.status, Status::kLost);
}

TEST(RunOdometry, NoFramesGiveNoResults) {
  const Wall wall;
  EXPECT_TRUE(run(wall.source(0), wall.camera(), kDefault).empty());
}

TEST(OdometryOptions, NameTheBadValue) {
  OdometryOptions options;
  options.solver = "magic";
  try {
    options.check();
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "solver: found 'magic', expected one of kabsch, p3p, eight-point, seven-point, nister-5pt, "
                 "stewenius-5pt, kneip-5pt-rotation, eigensolver, two-point, opencv-essential");
  }
  options = kDefault;
  options.scale = "none";
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
