// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/trajectory_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "framewise/geometry/so3.h"
#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path file_with(const std::string& content, const std::string& name = "trajectory.txt") {
  const fs::path path = test_file(name);
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

// The one line that reading this content is refused with.
std::string refusal(const std::string& content) {
  try {
    read_trajectory(file_with(content));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TrajectoryFiles, TumWithCommentsBlanksTabsAndAnyLineEnds) {
  const TrajectoryFile file = read_trajectory(file_with(
      "# a comment\r\n\r\n  1.5\t1  2 3 \t 0 0 0.6 0.8  \r\n2.5 4 +5 6e0 0 0 -1.2 -1.6 # tail\n#\n"));
  EXPECT_EQ(file.format, TrajectoryFormat::kTum);
  EXPECT_TRUE(file.has_times);
  ASSERT_EQ(file.trajectory.size(), 2u);
  EXPECT_EQ(file.trajectory.times, (std::vector<double>{1.5, 2.5}));
  EXPECT_EQ(file.trajectory.world_from_cam[1].t, Eigen::Vector3d(4, 5, 6));
  // qz 0.6, qw 0.8 turn x by 2 atan2(0.6, 0.8); the second is the same rotation, not of unit length.
  const Eigen::Vector3d x = file.trajectory.world_from_cam[0].R.col(0);
  EXPECT_LT((x - Eigen::Vector3d(0.28, 0.96, 0)).norm(), 1e-15);
  EXPECT_LT((file.trajectory.world_from_cam[1].R.col(0) - x).norm(), 1e-15);
}

TEST(TrajectoryFiles, KittiIsToldByItsTwelveColumns) {
  const fs::path path = file_with("1 0 0 7 0 0 -1 8 0 1 0 9\n1 0 0 1 0 1 0 2 0 0 1 3\n");
  const TrajectoryFile file = read_trajectory(path);
  EXPECT_EQ(file.format, TrajectoryFormat::kKitti);
  EXPECT_FALSE(file.has_times);
  EXPECT_EQ(file.trajectory.times, (std::vector<double>{0, 1}));
  EXPECT_EQ(file.trajectory.world_from_cam[0].t, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(file.trajectory.world_from_cam[0].R.row(1), Eigen::RowVector3d(0, 0, -1));

  const TrajectoryFile timed = read_trajectory(path, {}, file_with("0.0\n1.0e-01\n", "times.txt"));
  EXPECT_TRUE(timed.has_times);
  EXPECT_EQ(timed.trajectory.times, (std::vector<double>{0, 0.1}));
  EXPECT_THROW(read_trajectory(path, {}, file_with("0.0\n", "times.txt")), InputError);
}

TEST(TrajectoryFiles, EurocIsToldByItsNanosecondsAndCommas) {
  const TrajectoryFile file = read_trajectory(
      file_with("#timestamp, x, y, z, qw, qx, qy, qz, more\n1403636580838555648,1,2,3,0.8,0,0,0.6,9,9\n"));
  EXPECT_EQ(file.format, TrajectoryFormat::kEuroc);
  EXPECT_NEAR(file.trajectory.times[0], 1403636580.838555648, 1e-6);
  EXPECT_LT((file.trajectory.world_from_cam[0].R.col(0) - Eigen::Vector3d(0.28, 0.96, 0)).norm(), 1e-15);
}

TEST(TrajectoryFiles, WhatIsWrittenIsReadBack) {
  Trajectory written;
  written.add(1305031229.528748, {so3_exp({0.1, -2, 0.3}), {1.0 / 3, -1e-9, 1e6}});
  written.add(1305031229.628748, {so3_exp({0.1, -2, 0.3}), {1, 2, 3}});
  written.add(1600000000, {so3_exp({3, 1, 0.3}), {-0.0, 2, 0.1}});
  const fs::path path = file_with("");
  write_tum_trajectory(path, written);
  const Trajectory read = read_trajectory(path).trajectory;
  EXPECT_EQ(read.times, written.times);
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read.world_from_cam[i].t, written.world_from_cam[i].t);
    EXPECT_LT((read.world_from_cam[i].R - written.world_from_cam[i].R).norm(), 1e-15);
  }
  EXPECT_EQ(tum_line(1600000000, {Eigen::Matrix3d::Identity(), {-0.0, 2, 0.1}}),
            "1600000000 0 2 0.1 0 0 0 1");
  EXPECT_THROW(write_tum_trajectory(path.parent_path() / "no" / "such" / "folder.txt", read),
               std::runtime_error);
}

TEST(TrajectoryFiles, APoseWithTheStampOfTheOneBeforeIsLeftOutAndCounted) {
  const TrajectoryFile file =
      read_trajectory(file_with("1 0 0 0 0 0 0 1\n1 5 5 5 0 0 0 1\n2 0 0 0 0 0 0 1\n"));
  EXPECT_EQ(file.trajectory.size(), 2u);
  EXPECT_EQ(file.trajectory.world_from_cam[0].t.x(), 0);
  EXPECT_EQ(file.repeated, 1u);
}

TEST(TrajectoryFiles, ARefusalNamesFileLineFieldFoundAndExpected) {
  EXPECT_THAT(refusal("# c\n1 0 0 0 0 0 0 1\n2 0 abc 0 0 0 0 1\n"),
              HasSubstr("trajectory.txt:3: ty: found 'abc', expected a number"));
  EXPECT_THAT(refusal("1 0 0 0 0 0 0 1\n2 0 nan 0 0 0 0 1\n"),
              HasSubstr(":2: ty: found 'nan', expected a finite"));
  EXPECT_THAT(refusal("1 0 0 0 0 0 0 1\n2 0 1e999 0 0 0 0 1\n"), HasSubstr(":2: ty: found '1e999'"));
  EXPECT_THAT(refusal("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 1\n"), HasSubstr(":2: columns: found 7, expected 8"));
  EXPECT_THAT(refusal("1 2 3\n"), HasSubstr(":1: columns: found 3, expected 8 (TUM), 12 (KITTI)"));
  EXPECT_THAT(refusal("1 0 0 0 0 0 0 0\n"), HasSubstr(":1: quaternion: found length 0, expected"));
  EXPECT_THAT(
      refusal("5 0 0 0 0 0 0 1\n6 0 0 0 0 0 0 1\n5 0 0 0 0 0 0 1\n"),
      HasSubstr(":3: timestamp: found 5 after 6, expected stamps that increase (two runs in one file?)"));
  EXPECT_THAT(refusal("1 0 0 0 0 1 0 0 0 0 2 0\n"), HasSubstr(":1: rotation: found"));
  EXPECT_THAT(refusal(""), HasSubstr("found no poses"));
  EXPECT_THAT(refusal("# only\n# comments\n"), HasSubstr("found no poses"));
  EXPECT_THROW(read_trajectory("/no/such/file.txt"), InputError);
  EXPECT_THROW(read_trajectory(testing::TempDir()), InputError);
}

TEST(TrajectoryFiles, StampsThatAreNotSecondsAreNamed) {
  EXPECT_THAT(refusal("1305031229528748000 0 0 0 0 0 0 1\n"),
              HasSubstr("looks like nanoseconds, expected seconds"));
  EXPECT_THAT(refusal("1305031229528748 0 0 0 0 0 0 1\n"), HasSubstr("looks like microseconds"));
  EXPECT_THAT(refusal("1305031229528 0 0 0 0 0 0 1\n"), HasSubstr("looks like milliseconds"));
  EXPECT_THAT(refusal("0 0 0 0 0 0 0 1\n33333333 0 0 0 0 0 0 1\n"), HasSubstr("looks like nanoseconds"));
}

}  // namespace
}  // namespace framewise
