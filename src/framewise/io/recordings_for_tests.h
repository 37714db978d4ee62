// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "framewise/geometry/so3.h"
#include "framewise/io/dataset.h"

// A small recording that the tests write down in every format and read back.
namespace framewise {

// A folder of its own for each test, gone afterwards.
class RecordingTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = std::filesystem::temp_directory_path() /
            fmt::format("framewise_{}_{}", test->test_suite_name(), test->name());
    std::filesystem::remove_all(root_);
    folder_ = root_ / "recording";
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file, std::ios::binary) << text;
  }
  void write(const std::string& file, const cv::Mat& image) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    ASSERT_TRUE(cv::imwrite((folder_ / file).string(), image));
  }

  // The complaint about the recording, or "accepted".
  std::string refusal(const DatasetOptions& options = {}) const {
    try {
      const Dataset dataset = open_dataset(folder_, options);
      for (std::size_t i = 0; i < dataset.frames.size(); ++i) load_frame(dataset, i);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path root_, folder_;
};

inline constexpr int kWidth = 24, kHeight = 18, kFrames = 3;
inline Camera small_camera() { return {CameraModel::kPinhole, kWidth, kHeight, 20, 21, 11.5, 8.5, {}, {}}; }
inline std::string small_camera_yaml() {
  return "width: 24\nheight: 18\nfx: 20\nfy: 21\ncx: 11.5\ncy: 8.5\n";
}

inline cv::Mat color_image(int i) {
  cv::Mat image(kHeight, kWidth, CV_8UC3);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      image.at<cv::Vec3b>(v, u) = cv::Vec3b::all(static_cast<std::uint8_t>(4 * u + 5 * v + 20 * i));
  return image;
}

// Metres, in steps of 1/8 m, which every unit here holds exactly; one pixel unknown.
inline double true_depth(int i, int u, int v) {
  return u == 3 && v == 4 ? 0 : 1 + 0.125 * ((u + 2 * v + 3 * i) % 40);
}

inline cv::Mat raw_depth(int i, double factor) {
  cv::Mat raw(kHeight, kWidth, CV_16U);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      raw.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(std::lround(true_depth(i, u, v) * factor));
  return raw;
}

inline Pose true_pose(int i) { return {so3_exp({0.1 * i, 0.3 - 0.2 * i, 0.05}), {0.2 * i, -0.1, 1.0 + i}}; }

inline std::string matrix_rows(const Pose& pose, int rows, const char* between_rows) {
  std::string text;
  const Eigen::Matrix4d M = pose.matrix();
  for (int i = 0; i < rows; ++i)
    text += fmt::format("{}{} {} {} {}", i > 0 ? between_rows : "", M(i, 0), M(i, 1), M(i, 2), M(i, 3));
  return text + "\n";
}

inline void expect_same_pose(const Pose& found, const Pose& expected) {
  EXPECT_LT((found.matrix() - expected.matrix()).norm(), 1e-9);
}

// The recording above, whatever the files looked like.
struct Expected {
  std::string format;
  double first_time = 0, step = 1.0 / 30;
  bool color = true, depth = true, truth = true;
};

inline void expect_recording(const Dataset& dataset, const Expected& expected) {
  EXPECT_EQ(dataset.format, expected.format);
  EXPECT_FALSE(dataset.recognised_by.empty());
  EXPECT_EQ(dataset.fingerprint.size(), 16u);
  ASSERT_EQ(dataset.frames.size(), static_cast<std::size_t>(kFrames));
  EXPECT_EQ(dataset.frames_with_color, expected.color ? kFrames : 0u);
  EXPECT_EQ(dataset.frames_with_depth, expected.depth ? kFrames : 0u);
  EXPECT_EQ(dataset.truth.size(), expected.truth ? kFrames : 0u);
  for (int i = 0; i < kFrames; ++i) {
    const Frame frame = load_frame(dataset, static_cast<std::size_t>(i));
    EXPECT_NEAR(frame.time, expected.first_time + i * expected.step, 1e-6) << i;
    if (expected.truth)
      expect_same_pose(dataset.truth.world_from_cam[static_cast<std::size_t>(i)], true_pose(i));
    EXPECT_EQ(frame.gray.empty(), !expected.color);
    EXPECT_EQ(frame.depth.empty(), !expected.depth);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        if (expected.color) {
          ASSERT_NEAR(frame.gray.at<std::uint8_t>(v, u), 4 * u + 5 * v + 20 * i, 1);
        }
        if (!expected.depth) continue;
        const double z = true_depth(i, u, v);
        if (z > 0) {
          ASSERT_NEAR(frame.depth.at<float>(v, u), z, 1e-3) << u << ' ' << v;
        } else {
          ASSERT_TRUE(std::isnan(frame.depth.at<float>(v, u)));
        }
      }
  }
}

}  // namespace framewise
