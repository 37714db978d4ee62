// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/recording_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "framewise/geometry/so3.h"
#include "framewise/io/dataset.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

const Camera kCamera{CameraModel::kPinhole, 32, 24, 26.25, 26, 15.5, 11.25, {}, {}};

Frame frame_at(double time, float nearest) {
  Frame frame;
  frame.time = time;
  frame.color = cv::Mat(24, 32, CV_8UC3, cv::Scalar(80, 80, 80));
  frame.gray = cv::Mat(24, 32, CV_8U, cv::Scalar(80));
  frame.depth = cv::Mat(24, 32, CV_32F);
  for (int v = 0; v < 24; ++v)
    for (int u = 0; u < 32; ++u) frame.depth.at<float>(v, u) = nearest + 0.125f * static_cast<float>(u);
  frame.depth.at<float>(3, 4) = std::numeric_limits<float>::quiet_NaN();
  return frame;
}

class EveryLayout : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    folder_ = test_file("recording");
    fs::remove_all(folder_);
    for (int i = 0; i <= 40; ++i)
      truth_.add(0.01 * i, {so3_exp({0.1 * i, 0.02, -0.03 * i}), {0.1 * i, -0.2 * i, 1}});
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::unique_ptr<RecordingWriter> writer() const {
    const double factor = GetParam() == "kitti-depth" ? 256 : 5000;
    return recording_writer(GetParam(), folder_, kCamera, {factor, DepthType::kZ, std::nullopt}, 10);
  }
  void record(bool with_imu) const {
    const auto writer = this->writer();
    for (int i = 0; i < 4; ++i) writer->add(frame_at(0.1 * i, 1.0f + i), frame_at(0.1 * i, 1.5f + i).depth);
    writer->finish(truth_);
    if (with_imu) {
      const std::vector<ImuReading> readings{{0, {0.1, 0.2, 0.3}, {0, 0, 9.81}},
                                             {0.005, {0, 0, 1}, {1, 2, 3}}};
      writer->write_imu(readings, readings, 200);
    }
  }

  fs::path folder_;
  Trajectory truth_;
};

TEST_P(EveryLayout, IsReadBackAsItWasWritten) {
  record(true);
  const Dataset dataset = open_dataset(folder_, {});
  EXPECT_THAT(GetParam(), testing::StartsWith(dataset.format));
  ASSERT_EQ(dataset.frames.size(), 4u);
  const Camera& camera = dataset.calibration.camera;
  for (const auto& [found, written] : {std::pair(camera.fx, kCamera.fx),
                                       {camera.fy, kCamera.fy},
                                       {camera.cx, kCamera.cx},
                                       {camera.cy, kCamera.cy}})
    EXPECT_EQ(found, written);
  const Trajectory at_frames = truth_at_frames(dataset, 0.001);
  ASSERT_EQ(at_frames.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(dataset.frames[i].time, 0.1 * i, 1e-9);
    EXPECT_LT((at_frames.world_from_cam[i].matrix() - truth_.world_from_cam[10 * i].matrix()).norm(), 1e-12);
    const Frame frame = load_frame(dataset, i);
    EXPECT_EQ(frame.gray.at<std::uint8_t>(7, 7), 80);
    if (GetParam() == "euroc") continue;  // its reader knows no depth
    ASSERT_FALSE(frame.depth.empty());
    EXPECT_FLOAT_EQ(frame.depth.at<float>(5, 16), 3.0f + static_cast<float>(i));
    EXPECT_TRUE(std::isnan(frame.depth.at<float>(3, 4)));
  }
  if (GetParam() == "euroc") {
    ASSERT_EQ(dataset.gyroscope.size(), 2u);
    EXPECT_EQ(dataset.gyroscope.rates[0], Eigen::Vector3d(0.1, 0.2, 0.3));
  }
}

TEST_P(EveryLayout, RefusesAFolderThatHoldsARecording) {
  record(false);
  EXPECT_THROW(writer(), std::invalid_argument);
}

TEST_P(EveryLayout, RefusesFramesThatDoNotFit) {
  const auto writer = this->writer();
  writer->add(frame_at(0.5, 1));
  EXPECT_THROW(writer->add(frame_at(0.5, 1)), std::invalid_argument) << "no time between them";
  EXPECT_THROW(writer->add(frame_at(0.6, 1), frame_at(0.6, 1).depth), std::invalid_argument)
      << "true depth late";
  Frame narrow = frame_at(0.7, 1);
  narrow.depth = narrow.depth.colRange(0, 9).clone();
  EXPECT_THROW(writer->add(narrow), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout, testing::ValuesIn(recording_layouts()), [](const auto& info) {
  std::string name = info.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

TEST(RecordingWriter, RefusesWhatALayoutCannotHold) {
  const fs::path folder = fs::temp_directory_path() / "framewise_recording_writer_none";
  const auto refusal = [&](const std::string& layout, const Camera& camera, const DepthStorage& storage) {
    try {
      recording_writer(layout, folder, camera, storage, 30);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  Camera bent = kCamera;
  bent.distortion[4] = 0.1;
  EXPECT_THAT(refusal("euroc", bent, {}), testing::HasSubstr("k3 = 0"));
  EXPECT_THAT(refusal("kitti-depth", bent, {256, DepthType::kZ, std::nullopt}),
              testing::HasSubstr("without distortion"));
  EXPECT_THAT(refusal("kitti-depth", kCamera, {}), testing::HasSubstr("256 units"));
  EXPECT_THAT(refusal("bag", kCamera, {}), testing::HasSubstr("layout is 'bag', expected one of: tum"));
  EXPECT_FALSE(fs::exists(folder));
}

TEST(RecordingWriter, DepthOfTheKittiLayoutIsARecordingByItself) {
  const fs::path folder = fs::temp_directory_path() / "framewise_recording_writer_depth";
  fs::remove_all(folder);
  {
    const auto writer =
        recording_writer("kitti-depth", folder, kCamera, {256, DepthType::kZ, std::nullopt}, 10);
    writer->add(frame_at(0, 1), frame_at(0, 1).depth);
    Trajectory truth;
    truth.add(0, {});
    writer->finish(truth);
  }
  for (const char* name : {"velodyne_raw", "groundtruth"}) {
    const Dataset dataset = open_dataset(folder / "proj_depth" / name / "image_02", {});
    EXPECT_EQ(dataset.format, "kitti-depth");
    EXPECT_FLOAT_EQ(load_frame(dataset, 0).depth.at<float>(5, 16), 3);
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace framewise
