// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/imu_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>
#include <vector>

#include "framewise/io/gyroscope_file.h"

namespace framewise {
namespace {

TEST(ImuWriter, WhatItWritesTheReaderReadsBackExactly) {
  const auto file =
      std::filesystem::temp_directory_path() / ("imu_writer_" + std::to_string(getpid()) + ".csv");
  const std::vector<ImuReading> readings{{0, {0.1, -2e-9, 1.0 / 3}, {0, 0, 9.81}},
                                         {0.005, {M_PI, 0, -1}, {1, 2, 3}}};
  write_imu(file, readings);
  const Gyroscope gyroscope = read_gyroscope(file);
  std::filesystem::remove(file);
  ASSERT_EQ(gyroscope.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(gyroscope.times[i], readings[i].time);
    EXPECT_EQ(gyroscope.rates[i], readings[i].angular_rate);
  }
}

TEST(ImuWriter, SaysWhichFileCannotBeWritten) {
  try {
    write_imu("/no/such/folder/imu.csv", {});
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/imu.csv"), std::string::npos);
  }
}

}  // namespace
}  // namespace framewise
