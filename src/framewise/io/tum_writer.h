// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "framewise/io/recording_writer.h"

namespace framewise {

// The layout of the TUM RGB-D benchmark:
//   rgb.txt, depth.txt     `time file`, times with six decimals
//   rgb/*.png              8-bit colour
//   depth/*.png            16-bit z, metres times depth_factor, 0 where unknown or out of the 16 bits
//   groundtruth.txt        `time tx ty tz qx qy qz qw`, world_from_cam, every digit of a double
//   depth_true.txt, depth_true/*.png    where depth without the sensor's faults is given too: the same of it
//   camera.yaml            the camera, as docs say, with depth_factor and what else tells how depth is stored
//   imu.csv, imu_true.csv  in EuRoC's form, where there is an inertial unit
class TumWriter final : public RecordingWriter {
 public:
  TumWriter(const std::filesystem::path& folder, const Camera& camera, const DepthStorage& storage);
  TumWriter(const std::filesystem::path& folder, const Camera& camera, double depth_factor = 5000);

  void finish(const Trajectory& truth) override;
  void write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth,
                 double rate_hz) override;

 private:
  std::ofstream rgb_list_, depth_list_, true_depth_list_;

  void write_frame(const Frame& frame, const cv::Mat& true_depth) override;
  void write_depth(const std::string& folder, const std::string& stamp, const cv::Mat& depth,
                   std::ofstream& list);
};

}  // namespace framewise
