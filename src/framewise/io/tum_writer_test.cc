// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/tum_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

class TumWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("framewise_tum_writer_") + test->name()) / "deep";
    fs::remove_all(folder_.parent_path());
  }
  void TearDown() override { fs::remove_all(folder_.parent_path()); }

  static std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  static Frame frame_at(double time) {
    Frame frame;
    frame.time = time;
    frame.color = cv::Mat(12, 16, CV_8UC3);
    frame.depth = cv::Mat(12, 16, CV_32F);
    for (int v = 0; v < 12; ++v) {
      for (int u = 0; u < 16; ++u) {
        frame.color.at<cv::Vec3b>(v, u) = {static_cast<std::uint8_t>(10 * u),
                                           static_cast<std::uint8_t>(20 * v), 7};
        frame.depth.at<float>(v, u) = 1.0f + 0.1f * static_cast<float>(u);
      }
    }
    return frame;
  }

  const Camera camera_{CameraModel::kPinhole, 16, 12, 13.125, 13.125, 7.5, 5.5, {}, {}};
  fs::path folder_;
};

TEST_F(TumWriterTest, WritesTheLayoutOfTheBenchmark) {
  TumWriter writer(folder_, camera_);
  writer.add(frame_at(0));
  writer.add(frame_at(0.033333));
  writer.finish({});
  EXPECT_EQ(text_of(folder_ / "rgb.txt"),
            "# color images\n# timestamp filename\n0.000000 rgb/0.000000.png\n0.033333 rgb/0.033333.png\n");
  EXPECT_EQ(text_of(folder_ / "depth.txt"),
            "# depth maps\n# timestamp filename\n0.000000 depth/0.000000.png\n0.033333 depth/0.033333.png\n");
  EXPECT_EQ(
      text_of(folder_ / "camera.yaml"),
      "# depth is registered to this camera\nmodel: pinhole\nwidth: 16\nheight: 12\nfx: 13.125\nfy: 13.125\n"
      "cx: 7.5\ncy: 5.5\ndistortion: [0, 0, 0, 0, 0]\ndepth_factor: 5000\n");
}

TEST_F(TumWriterTest, ColorComesBackAndDepthToATenthOfAMillimetre) {
  Frame frame = frame_at(1.5);
  frame.depth.at<float>(0, 0) = std::numeric_limits<float>::quiet_NaN();
  frame.depth.at<float>(0, 1) = 13.2f;  // more than 65535 / 5000
  TumWriter writer(folder_, camera_);
  writer.add(frame);
  const cv::Mat color = cv::imread((folder_ / "rgb/1.500000.png").string(), cv::IMREAD_UNCHANGED);
  const cv::Mat depth = cv::imread((folder_ / "depth/1.500000.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(color.type(), CV_8UC3);
  EXPECT_EQ(0, std::memcmp(color.data, frame.color.data, 12 * 16 * 3));
  ASSERT_EQ(depth.type(), CV_16U);
  EXPECT_EQ(depth.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(depth.at<std::uint16_t>(0, 1), 0);
  for (int u = 2; u < 16; ++u)
    EXPECT_NEAR(depth.at<std::uint16_t>(3, u) / 5000.0, frame.depth.at<float>(3, u), 1.0001e-4);
}

TEST_F(TumWriterTest, TruthKeepsEveryDigit) {
  const Pose pose{so3_exp({0.1, -0.7, 1.3}), {1.0 / 3, -2.0 / 7, 1e-9}};
  Trajectory truth;
  truth.add(0.25, pose);
  TumWriter(folder_, camera_).finish(truth);
  std::istringstream text(text_of(folder_ / "groundtruth.txt"));
  std::string line;
  do std::getline(text, line);
  while (line[0] == '#');
  double time, tx, ty, tz, qx, qy, qz, qw;
  std::istringstream(line) >> time >> tx >> ty >> tz >> qx >> qy >> qz >> qw;
  EXPECT_EQ(time, 0.25);
  EXPECT_EQ(Eigen::Vector3d(tx, ty, tz), pose.t);
  EXPECT_LT((Pose::from_quaternion({qw, qx, qy, qz}, pose.t).R - pose.R).norm(), 1e-15 * 10);
}

TEST_F(TumWriterTest, RefusesWhatWouldSpoilARecording) {
  TumWriter writer(folder_, camera_);
  writer.add(frame_at(1));
  EXPECT_THROW(writer.add(frame_at(1)), std::invalid_argument) << "the same time twice";
  EXPECT_THROW(writer.add(frame_at(0.5)), std::invalid_argument);
  Frame wrong = frame_at(2);
  wrong.depth.convertTo(wrong.depth, CV_16U);
  EXPECT_THROW(writer.add(wrong), std::invalid_argument);
  wrong = frame_at(2);
  wrong.color = wrong.color.rowRange(0, 5);
  EXPECT_THROW(writer.add(wrong), std::invalid_argument);
  try {
    TumWriter(folder_, camera_);
    FAIL() << "a recording would be mixed with another";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("rgb.txt exists"));
  }
}

TEST_F(TumWriterTest, NamesTheFolderItCannotMake) {
  fs::create_directories(folder_.parent_path());
  std::ofstream(folder_) << "a file in the way";
  try {
    TumWriter(folder_, camera_);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("deep"));
  }
}

}  // namespace
}  // namespace framewise
