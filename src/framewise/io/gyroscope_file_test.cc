// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/gyroscope_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path imu_csv(const std::string& text) {
  const fs::path path = test_file("imu_data.csv");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string refusal(const std::string& text) {
  try {
    read_gyroscope(imu_csv(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(GyroscopeFile, ReadsEurocsInertialUnit) {
  const Gyroscope gyroscope = read_gyroscope(
      imu_csv("#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],a_RS_S_x,a,a\r\n"
              "1403636579758555392,-0.099,0.147,0.0279,8.17,-0.37,-2.4\r\n"
              "1403636579763555584,-0.1,0.14,-0.03,8,0,0\r\n"));
  ASSERT_EQ(gyroscope.size(), 2u);
  EXPECT_NEAR(gyroscope.times[0], 1403636579.758555392, 1e-6);
  EXPECT_EQ(gyroscope.rates[0], Eigen::Vector3d(-0.099, 0.147, 0.0279));
  EXPECT_EQ(gyroscope.rates[1].z(), -0.03);
  EXPECT_TRUE(gyroscope.cam_from_gyro.isIdentity(0));
}

TEST(GyroscopeFile, ReadsRatesAlone) {
  const Gyroscope gyroscope = read_gyroscope(imu_csv("0,1,2,3\n5000000,4,5,6\n"));
  EXPECT_EQ(gyroscope.times, (std::vector<double>{0, 0.005}));
  EXPECT_EQ(gyroscope.rates[1], Eigen::Vector3d(4, 5, 6));
}

TEST(GyroscopeFile, ARefusalNamesLineFieldFoundAndExpected) {
  EXPECT_THAT(refusal("0,1,2,3\n5000000,x,5,6\n"), HasSubstr(":2: w_RS_S_x: found 'x', expected a number"));
  EXPECT_THAT(refusal("0,1,2,3\n5000000,1,nan,6\n"), HasSubstr(":2: w_RS_S_y: found 'nan'"));
  EXPECT_THAT(refusal("0,1,2\n"), HasSubstr(":1: columns: found 3, expected 4 or 7"));
  EXPECT_THAT(refusal("0,1,2,3\n0,1,2,3\n"), HasSubstr(":2: timestamp: found '0', not after the one before"));
  EXPECT_THAT(refusal("0.5,1,2,3\n"),
              HasSubstr(":1: timestamp: found '0.5', expected a whole number of nano"));
  EXPECT_THAT(refusal("0,1,2,3\n5,1,2,3\n"), HasSubstr("apart, expected nanoseconds"));
  EXPECT_THAT(refusal("0,1,2,3\n5000000,300,0,0\n"),
              HasSubstr(":2: w_RS_S_x: found 300, expected a rate in rad/s"));
  EXPECT_THAT(refusal("# only a comment\n"), HasSubstr("no rates"));
  EXPECT_THROW(read_gyroscope("/no/such/data.csv"), InputError);
  EXPECT_THROW(read_gyroscope(testing::TempDir()), InputError);
}

}  // namespace
}  // namespace framewise
