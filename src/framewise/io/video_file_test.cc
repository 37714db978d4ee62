// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/video_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>
#include <thread>

#include "framewise/io/input_error.h"
#include "framewise/io/recordings_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
constexpr int kLength = 60;

// Frame i is an even gray of 4 i.
class VideoFileTest : public RecordingTest {
 protected:
  void SetUp() override {
    RecordingTest::SetUp();
    path_ = folder_ / "film.avi";
    cv::VideoWriter writer(path_.string(), cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           25, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < kLength; ++i) writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(4 * i)));
  }
  static void expect_frame(const cv::Mat& gray, std::size_t i) {
    ASSERT_EQ(gray.type(), CV_8U);
    ASSERT_EQ(gray.size(), cv::Size(64, 48));
    EXPECT_NEAR(gray.at<std::uint8_t>(20, 30), 4 * static_cast<double>(i), 2) << i;
  }
  fs::path path_;
};

TEST_F(VideoFileTest, FramesComeInAnyOrder) {
  VideoFile video(path_);
  ASSERT_EQ(video.times().size(), static_cast<std::size_t>(kLength));
  EXPECT_NEAR(video.times()[10], 0.4, 0.041);
  EXPECT_NEAR(video.times()[11] - video.times()[10], 0.04, 1e-6);
  for (const std::size_t i : {0, 1, 3, 2, 4, 7, 6, 5, 59, 58, 8, 0, 30}) expect_frame(video.gray(i), i);
  EXPECT_THROW(video.gray(kLength), InputError);
  expect_frame(video.gray(3), 3);
}

TEST_F(VideoFileTest, ThreadsMayAskSideBySide) {
  VideoFile video(path_);
  std::vector<cv::Mat> frames(kLength);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 4; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < kLength; i += 4) frames[i] = video.gray(i);
      });
  }
  for (std::size_t i = 0; i < kLength; ++i) expect_frame(frames[i], i);
}

TEST_F(VideoFileTest, IsADataSet) {
  write("camera.yaml", "width: 64\nheight: 48\nfx: 50\nfy: 50\ncx: 31.5\ncy: 23.5\n");
  const Dataset dataset = open_dataset(path_, {});
  EXPECT_EQ(dataset.format, "video");
  EXPECT_EQ(dataset.name, "film.avi");
  ASSERT_EQ(dataset.frames.size(), static_cast<std::size_t>(kLength));
  EXPECT_EQ(dataset.frames_with_color, static_cast<std::size_t>(kLength));
  const Frame frame = load_frame(dataset, 12);
  expect_frame(frame.gray, 12);
  EXPECT_EQ(frame.time, dataset.frames[12].time);
  DatasetOptions options;
  options.fps = 10;
  EXPECT_NEAR(open_dataset(path_, options).frames[5].time, 0.5, 1e-12);
}

TEST_F(VideoFileTest, WhatIsNoVideoIsRefused) {
  EXPECT_THROW(VideoFile(folder_ / "nothing.avi"), InputError);
  EXPECT_THROW(VideoFile{folder_}, InputError);
  write("text.avi", "not a film");
  EXPECT_THROW(VideoFile(folder_ / "text.avi"), InputError);
  fs::resize_file(path_, 100);
  EXPECT_THROW(VideoFile{path_}, InputError);
}

}  // namespace
}  // namespace framewise
