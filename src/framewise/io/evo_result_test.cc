// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/evo_result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

struct EvoResultFile : ::testing::Test {
  void SetUp() override {
    folder = fs::path(::testing::TempDir()) / ("evo_result_test_" + std::to_string(getpid()));
    fs::create_directories(folder);
    result.title = "APE w.r.t. translation part (m)\n(not aligned)";
    result.reference_name = "truth.txt";
    result.estimate_name = "run.tum";
    result.statistics = {{"rmse", 0.125}};
    for (int i = 0; i < 3; ++i) {
      result.reference.add(i, {Eigen::Matrix3d::Identity(), {1.0 * i, 0, 0}});
      result.estimate.add(i, {Eigen::Matrix3d::Identity(), {1.0 * i, 0.5, 0}});
    }
    result.errors = {0.5, 0.5, 0.5};
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string written() const {
    write_evo_result(folder / "a.zip", result, "--save-results");
    std::ifstream file(folder / "a.zip", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  fs::path folder;
  EvoResult result;
};

template <typename... Doubles>
std::string bytes_of(Doubles... doubles) {
  const std::vector<double> values = {static_cast<double>(doubles)...};
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

TEST_F(EvoResultFile, HoldsWordsFiguresArraysAndTrajectories) {
  const std::string archive = written();
  EXPECT_THAT(archive, HasSubstr(R"x("title":"APE w.r.t. translation part (m)\n(not aligned)")x"));
  EXPECT_THAT(archive, HasSubstr(R"({"rmse":0.125})"));
  for (const char* name : {"error_array.npy", "timestamps.npy", "seconds_from_start.npy",
                           "distances_from_start.npy", "distances.npy", "truth.txt.tum", "run.tum.tum"})
    EXPECT_THAT(archive, HasSubstr(name));
  EXPECT_THAT(archive, Not(HasSubstr("alignment_transformation_sim3")));
  EXPECT_THAT(archive, HasSubstr("2 2 0.5 0 0 0 0 1\n"));
}

TEST_F(EvoResultFile, AnArrayBeginsAfterAHeaderOfAMultipleOf64Bytes) {
  const std::string archive = written();
  const std::size_t magic = archive.find("\x93NUMPY"), data = archive.find(bytes_of(0.5, 0.5, 0.5));
  ASSERT_NE(magic, std::string::npos);
  ASSERT_NE(data, std::string::npos);
  EXPECT_EQ((data - magic) % 64, 0u);
  EXPECT_EQ(archive[data - 1], '\n');
  EXPECT_THAT(archive.substr(magic, data - magic),
              HasSubstr("{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }"));
}

TEST_F(EvoResultFile, TheFirstPoseOfRelativeErrorsHasNoError) {
  result.errors = {0.25, 0.75};
  EXPECT_THAT(written(), HasSubstr(bytes_of(1, 2)));  // timestamps, and the way to them
  EXPECT_THAT(written(), Not(HasSubstr(bytes_of(0, 1, 2))));
}

TEST_F(EvoResultFile, AnAlignmentIsAMatrixRowByRow) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M(0, 3) = 7;
  result.alignment = M;
  EXPECT_THAT(written(), HasSubstr(bytes_of(1, 0, 0, 7, 0, 1)));
  EXPECT_THAT(written(), HasSubstr("'shape': (4, 4), }"));
}

TEST_F(EvoResultFile, PosesWithoutStampsAreKittis) {
  result.has_times = false;
  const std::string archive = written();
  EXPECT_THAT(archive, HasSubstr("run.tum.kitti"));
  EXPECT_THAT(archive, HasSubstr("1 0 0 2 0 1 0 0.5 0 0 1 0\n"));
  EXPECT_THAT(archive, Not(HasSubstr("timestamps")));
}

TEST_F(EvoResultFile, HasTheSameBytesEveryTime) { EXPECT_EQ(written(), written()); }

TEST_F(EvoResultFile, PosesThatAreNoneOfTheErrorsAreRefused) {
  result.errors = {0.5};
  EXPECT_THROW(written(), std::invalid_argument);
  result.errors = {0.5, 0.5, 0.5, 0.5};
  EXPECT_THROW(written(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
