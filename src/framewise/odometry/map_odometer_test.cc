// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_odometer.h"

#include <gtest/gtest.h>

#include <mutex>
#include <stdexcept>

#include "framewise/odometry/boxes_for_tests.h"

namespace framewise {
namespace {

struct BothRuns {
  std::vector<FrameResult> causal;
  std::vector<Pose> final_poses;
};

BothRuns run(const FrameSource& source, int threads = 1, MapOptions map = {}) {
  OdometryOptions options;
  options.reference = "map";
  options.threads = threads;
  options.map = map;
  BothRuns result;
  const MapRun end = run_map_odometry(
      source, Boxes::camera(), options, [] { return 0.0; },
      [&](const FrameResult& r) { result.causal.push_back(r); });
  result.final_poses = end.final_poses;
  return result;
}

// To the side and turning, 2 cm and 0.6 degrees a frame.
Pose sideways(std::size_t i) {
  const double s = static_cast<double>(i);
  return {so3_exp({0, -0.01 * s, 0.002 * s}), {0.02 * s, 0.004 * s, 0.003 * s}};
}

double position_error(const Pose& found, const Pose& expected) { return (found.t - expected.t).norm(); }
double angle_error(const Pose& found, const Pose& expected) {
  return rotation_angle(found.R.transpose() * expected.R);
}

TEST(RunMapOdometry, FollowsAKnownMotionInMetres) {
  const Boxes boxes;
  const auto result = run(boxes.source(20, sideways));
  ASSERT_EQ(result.causal.size(), 20u);
  ASSERT_EQ(result.final_poses.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(result.causal[i].index, i);
    EXPECT_EQ(result.causal[i].step.status, Status::kOk) << i;
    EXPECT_LT(position_error(result.causal[i].world_from_cam, sideways(i)), 0.003) << i;
    EXPECT_LT(angle_error(result.causal[i].world_from_cam, sideways(i)), 0.002) << i;
    EXPECT_LT(position_error(result.final_poses[i], sideways(i)), 0.003) << i;
  }
}

// 9 cm and 2.4 degrees a frame.
Pose striding(std::size_t i) {
  const double s = static_cast<double>(i);
  return {so3_exp({0, -0.04 * std::sin(0.8 * s), 0.01 * s}), {0.04 * s, 0.02 * std::sin(s), 0.08 * s - 0.9}};
}

TEST(RunMapOdometry, WithDepthALensIsAsItWasCalibrated) {
  const Boxes boxes;
  MapOptions map;
  map.adjust = "always";
  map.keyframe_share = 0.95;
  const auto expected = run(boxes.source(12, striding), 1, map);
  map.learn_lens = false;
  const auto found = run(boxes.source(12, striding), 1, map);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_EQ(found.causal[i].world_from_cam.matrix(), expected.causal[i].world_from_cam.matrix()) << i;
}

// Holes of 80 pixels, each elsewhere in each frame; three fifths of all depth.
FrameSource holed(FrameSource source) {
  source.load = [load = source.load](std::size_t index) {
    Frame frame = load(index);
    cv::RNG rng(index + 5);
    for (int k = 0; k < 12; ++k) {
      const cv::Rect hole(rng.uniform(-40, 280), rng.uniform(-40, 200), 80, 80);
      frame.depth(hole & cv::Rect({}, frame.depth.size())) = std::numeric_limits<float>::quiet_NaN();
    }
    return frame;
  };
  return source;
}

TEST(RunMapOdometry, LongStridesAndHolesInTheDepthLeaveItWhereItIs) {
  const Boxes boxes;
  const auto whole = run(boxes.source(14, striding)), parts = run(holed(boxes.source(14, striding)));
  for (const auto* result : {&whole, &parts})
    for (std::size_t i = 0; i < 14; ++i) {
      const Pose expected = striding(0).inverse() * striding(i);
      EXPECT_EQ(result->causal[i].step.status, Status::kOk) << i;
      EXPECT_LT(position_error(result->causal[i].world_from_cam, expected), 0.006) << i;
      EXPECT_LT(angle_error(result->causal[i].world_from_cam, expected), 0.003) << i;
    }
}

TEST(RunMapOdometry, IsTheSameAtAnyThreadCount) {
  const Boxes boxes;
  const auto expected = run(boxes.source(14, sideways), 1);
  for (const int threads : {2, 5}) {
    const auto found = run(boxes.source(14, sideways), threads);
    ASSERT_EQ(found.causal.size(), expected.causal.size());
    for (std::size_t i = 0; i < found.causal.size(); ++i) {
      EXPECT_EQ(found.causal[i].world_from_cam.matrix(), expected.causal[i].world_from_cam.matrix()) << i;
      EXPECT_EQ(found.final_poses[i].matrix(), expected.final_poses[i].matrix()) << i;
    }
  }
}

TEST(RunMapOdometry, AStandingCameraStands) {
  const Boxes boxes;
  const auto result = run(boxes.source(12, [](std::size_t) { return sideways(3); }));
  for (const FrameResult& frame : result.causal) {
    EXPECT_LT(frame.world_from_cam.t.norm(), 1e-4);
    EXPECT_LT(rotation_angle(frame.world_from_cam.R), 1e-4);
  }
}

// Frames 8 to 10 show nothing.
FrameSource covered(const Boxes& boxes) {
  FrameSource source = boxes.source(18, sideways);
  source.load = [load = source.load](std::size_t i) {
    Frame frame = load(i);
    if (i >= 8 && i <= 10) frame.gray = cv::Scalar(70), frame.depth = std::numeric_limits<float>::quiet_NaN();
    return frame;
  };
  return source;
}

TEST(RunMapOdometry, ForetellsWhatACoveredLensHidesAndFindsItselfAgain) {
  const Boxes boxes;
  const auto result = run(covered(boxes));
  for (std::size_t i = 0; i < 18; ++i) {
    const bool hidden = i >= 8 && i <= 10;
    EXPECT_EQ(result.causal[i].step.status, hidden ? Status::kPredicted : Status::kOk) << i;
    if (!hidden) {
      EXPECT_LT(position_error(result.causal[i].world_from_cam, sideways(i)), 0.004) << i;
    }
  }
}

TEST(RunMapOdometry, GoesOnWithoutDepthOnceItHasAMap) {
  const Boxes boxes;
  FrameSource source = boxes.source(14, sideways);
  source.load = [load = source.load](std::size_t i) {
    Frame frame = load(i);
    if (i >= 5 && i <= 9) frame.depth.release();
    return frame;
  };
  const auto result = run(source);
  for (std::size_t i = 0; i < 14; ++i)
    EXPECT_LT(position_error(result.causal[i].world_from_cam, sideways(i)), 0.006) << i;
}

// Frames 6 to 26 show a wall without texture at 1.5 m, in noise; then the camera is back.
TEST(RunMapOdometry, TakesNoWhiteWallForAPlaceAndFindsItselfAfterIt) {
  const Boxes boxes;
  const auto path = [](std::size_t i) { return sideways(i < 6 ? i : i < 27 ? 6 : i - 21); };
  FrameSource source = boxes.source(34, path);
  source.load = [load = source.load](std::size_t i) {
    Frame frame = load(i);
    if (i < 6 || i > 26) return frame;
    cv::RNG rng(i);
    rng.fill(frame.gray, cv::RNG::NORMAL, 200, 4);
    frame.depth = 1.5f;
    return frame;
  };
  const auto result = run(source);
  for (std::size_t i = 0; i < 34; ++i) {
    const Status status = result.causal[i].step.status;
    EXPECT_EQ(status, i < 6 || i > 26 ? Status::kOk : i < 16 ? Status::kPredicted : Status::kLost) << i;
    if (status == Status::kOk) {
      EXPECT_LT(position_error(result.causal[i].world_from_cam, path(i)), 0.004) << i;
    }
  }
}

// After frame 7 the camera is where nothing is known: what it sees there it follows at once, as a motion from
// where it was believed to be. Frame 10 is the last of which no motion counts.
TEST(RunMapOdometry, FollowsAnUnknownPlaceAndAnnouncesThatItsPoseIsForetold) {
  const Boxes boxes;
  const auto path = [](std::size_t i) {
    Pose pose = sideways(i);
    if (i > 7) pose.t.x() += 9;
    return pose;
  };
  const auto result = run(boxes.source(26, path));
  for (std::size_t i = 0; i < 26; ++i) {
    const Status expected = i <= 7 || i > 10 ? Status::kOk : i < 10 ? Status::kPredicted : Status::kLost;
    EXPECT_EQ(result.causal[i].step.status, expected) << i;
  }
  const auto from = [&](std::size_t a, std::size_t b) {
    return result.causal[a].world_from_cam.inverse() * result.causal[b].world_from_cam;
  };
  const auto true_from = [&](std::size_t a, std::size_t b) { return path(a).inverse() * path(b); };
  EXPECT_LT(position_error(from(8, 25), true_from(8, 25)), 0.006);
  EXPECT_LT(angle_error(from(8, 25), true_from(8, 25)), 0.004);
}

// Frames 8 to 13 are elsewhere, and then the camera is back within the second: the map that waited has it
// where it is, and the step there, which no two frames tell, is none that is `ok`.
TEST(RunMapOdometry, ReturnsFromElsewhereToTheMapThatWaitedAndAnnouncesTheJump) {
  const Boxes boxes;
  const auto path = [](std::size_t i) {
    Pose pose = sideways(i);
    if (i > 7 && i < 14) pose.t.x() += 9;
    return pose;
  };
  const auto result = run(boxes.source(20, path));
  for (std::size_t i = 0; i < 20; ++i) {
    const bool is_known = i <= 7 || i >= 14;
    const Status expected = i == 8 || i == 9 || i == 14 ? Status::kPredicted
                            : i == 10                   ? Status::kLost
                                                        : Status::kOk;
    EXPECT_EQ(result.causal[i].step.status, expected) << i;
    if (is_known) {
      EXPECT_LT(position_error(result.causal[i].world_from_cam, path(i)), 0.006) << i;
    }
  }
}

// Where depth gave the map its metres, a part without depth has none: it is not passed off as measured.
TEST(RunMapOdometry, NoLengthIsGuessedWhereLengthsWereMeasured) {
  const Boxes boxes;
  FrameSource source = boxes.source(24, [](std::size_t i) {
    Pose pose = sideways(i);
    if (i > 7) pose.t.x() += 9;
    return pose;
  });
  source.load = [load = source.load](std::size_t i) {
    Frame frame = load(i);
    if (i > 7) frame.depth.release();
    return frame;
  };
  const auto result = run(source);
  for (std::size_t i = 8; i < 24; ++i) {
    const Status status = result.causal[i].step.status;
    EXPECT_TRUE(status != Status::kOk && status != Status::kLowParallax) << i;
  }
}

TEST(RunMapOdometry, AGapInTheStampsIsAMotionLikeAnyOther) {
  const Boxes boxes;
  const auto kept = [](std::size_t i) { return i < 8 ? i : i + 5; };
  FrameSource source = boxes.source(25, sideways);
  source.size = 18;
  source.load = [load = source.load, kept](std::size_t i) { return load(kept(i)); };
  const auto result = run(source);
  for (std::size_t i = 0; i < 18; ++i) {
    EXPECT_EQ(result.causal[i].step.status, Status::kOk) << i;
    EXPECT_LT(position_error(result.causal[i].world_from_cam, sideways(kept(i))), 0.004) << i;
  }
}

TEST(RunMapOdometry, ADepthImageOfNothingIsNoDepthImage) {
  const Boxes boxes;
  const auto without = [&](const std::function<void(Frame&)>& take_depth) {
    FrameSource source = boxes.source(14, sideways);
    source.load = [load = source.load, take_depth](std::size_t i) {
      Frame frame = load(i);
      if (i >= 5 && i <= 9) take_depth(frame);
      return frame;
    };
    return run(source);
  };
  const auto missing = without([](Frame& frame) { frame.depth.release(); });
  const auto empty = without([](Frame& frame) { frame.depth = std::numeric_limits<float>::quiet_NaN(); });
  for (std::size_t i = 0; i < 14; ++i)
    EXPECT_EQ(missing.causal[i].world_from_cam.matrix(), empty.causal[i].world_from_cam.matrix()) << i;
}

TEST(RunMapOdometry, HandsOverWhatCameBeforeAFailure) {
  const Boxes boxes;
  FrameSource source = boxes.source(30, sideways);
  std::mutex mutex;
  std::vector<cv::Mat> loaded;
  source.load = [&, load = source.load](std::size_t i) {
    if (i == 6) throw std::runtime_error("frame 6 is broken");
    Frame frame = load(i);
    const std::lock_guard lock(mutex);
    loaded.push_back(frame.gray);
    return frame;
  };
  std::vector<std::size_t> seen;
  OdometryOptions options;
  options.reference = "map";
  EXPECT_THROW(run_map_odometry(
                   source, Boxes::camera(), options, [] { return 0.0; },
                   [&](const FrameResult& r) { seen.push_back(r.index); }),
               std::runtime_error);
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_LT(loaded.size(), 30u);
  for (const cv::Mat& gray : loaded) EXPECT_EQ(gray.u->refcount, 1);  // those on their way are let go
}

TEST(RunMapOdometry, NoFramesAndEmptyFramesAreNoCrash) {
  const Boxes boxes;
  EXPECT_TRUE(run(boxes.source(0, sideways)).causal.empty());
  FrameSource nothing{4,
                      [](std::size_t i) {
                        Frame frame;
                        frame.time = static_cast<double>(i);
                        return frame;
                      },
                      {}};
  const auto result = run(nothing);
  ASSERT_EQ(result.causal.size(), 4u);
  for (const FrameResult& frame : result.causal) EXPECT_TRUE(frame.world_from_cam.matrix().allFinite());
}

FrameSource without_depth(FrameSource source) {
  source.load = [load = source.load](std::size_t i) {
    Frame frame = load(i);
    frame.depth.release();
    return frame;
  };
  return source;
}

// Without depth, the first two views' baseline is the unit of length.
TEST(RunMapOdometry, WithoutDepthFollowsUpToOneScale) {
  const Boxes boxes;
  const FrameSource source = without_depth(boxes.source(24, sideways));
  const auto result = run(source);
  const double scale = sideways(23).t.norm() / result.causal[23].world_from_cam.t.norm();
  for (std::size_t i = 0; i < 24; ++i) {
    if (result.causal[i].step.status != Status::kOk) continue;
    EXPECT_LT((scale * result.causal[i].world_from_cam.t - sideways(i).t).norm(), 0.02) << i;
    EXPECT_LT(angle_error(result.causal[i].world_from_cam, sideways(i)), 0.01) << i;
  }
  EXPECT_EQ(result.causal[23].step.status, Status::kOk);
}

// From frame 8 on it looks now to one side, now to the other, by 29 degrees, and moves four times as far a
// frame: nothing is where it was expected, and the scale goes on all the same.
TEST(RunMapOdometry, WithoutDepthWideStepsKeepTheScale) {
  const Boxes boxes;
  const auto path = [](std::size_t i) {
    const double s = static_cast<double>(i), along = i < 8 ? 0.05 * s - 0.6 : 0.2 * (s - 7) - 0.25;
    const double turned = i < 8 ? 0 : i % 2 == 0 ? 0.25 : -0.25;
    return Pose{so3_exp({0, turned, 0}), {along, 0.01 * s, 0.01 * s}};
  };
  const FrameSource source = without_depth(boxes.source(14, path));
  const auto result = run(source);
  const auto length = [&](std::size_t a, std::size_t b) {
    return (result.causal[b].world_from_cam.t - result.causal[a].world_from_cam.t).norm();
  };
  const auto true_length = [&](std::size_t a, std::size_t b) { return (path(b).t - path(a).t).norm(); };
  for (std::size_t i = 7; i < 14; ++i) EXPECT_EQ(result.causal[i].step.status, Status::kOk) << i;
  EXPECT_NEAR(length(7, 13) / length(3, 7), true_length(7, 13) / true_length(3, 7), 0.3);
}

}  // namespace
}  // namespace framewise
