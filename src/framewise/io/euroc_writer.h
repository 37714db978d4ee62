// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "framewise/io/recording_writer.h"

namespace framewise {

// EuRoC's ASL format, stamps in nanoseconds; the camera, the inertial unit and the truth have one frame.
//   mav0/cam0/data.csv, sensor.yaml, data/*.png      gray images
//   mav0/depth0, depth0_true                         depth, the same way; camera.yaml says how it is stored
//   mav0/imu0, imu0_true                             where there is an inertial unit
//   mav0/mocap0/data.csv, sensor.yaml                world_from_cam: position, quaternion w x y z
//   Burri et al., The EuRoC micro aerial vehicle datasets, IJRR 2016.
class EurocWriter final : public RecordingWriter {
 public:
  // A pinhole whose k3 is 0: the format has four values of distortion.
  EurocWriter(const std::filesystem::path& folder, const Camera& camera, const DepthStorage& storage,
              double rate_hz);

  void finish(const Trajectory& truth) override;
  void write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth,
                 double rate_hz) override;

 private:
  struct ImageList {
    std::filesystem::path folder;
    std::ofstream lines;
  };
  ImageList gray_, depth_, true_depth_;
  double rate_hz_;

  void write_frame(const Frame& frame, const cv::Mat& true_depth) override;
  void begin(ImageList& list, const std::string& name) const;
};

}  // namespace framewise
