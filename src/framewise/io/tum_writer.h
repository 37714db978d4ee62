// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/trajectory.h"
#include "framewise/image/depth_rays.h"
#include "framewise/image/frame.h"

namespace framewise {

// Writes a recording in the layout of the TUM RGB-D benchmark, frame by frame:
//   rgb.txt, depth.txt     `time file`, times with six decimals
//   rgb/*.png              8-bit colour
//   depth/*.png            16-bit z, metres times depth_factor, 0 where unknown or out of the 16 bits
//   groundtruth.txt        `time tx ty tz qx qy qz qw`, world_from_cam, every digit of a double
//   depth_true.txt, depth_true/*.png    where depth without the sensor's faults is given too: the same of it
//   camera.yaml            the camera, as docs say, with depth_factor and what else tells how depth is stored
// A recording that ends early is complete up to its last frame once finish() was called.
// Failures to write throw std::runtime_error naming the file.
class TumWriter {
 public:
  struct DepthStorage {
    double factor = 5000;            // raw units in a metre
    DepthType type = DepthType::kZ;  // kRange: what is written is the distance along the pixel's ray
    std::optional<double> max;       // the sensor's reach, written beside it where it is given (m)
  };

  // Creates the folder and what is missing above it. Throws std::invalid_argument where it holds a recording
  // already.
  TumWriter(const std::filesystem::path& folder, const Camera& camera, const DepthStorage& storage);
  TumWriter(const std::filesystem::path& folder, const Camera& camera, double depth_factor = 5000);

  // Needs colour and depth of the camera's size, z in metres whatever is stored; times must grow by at least
  // a microsecond. True depth comes with all frames or with none.
  void add(const Frame& frame, const cv::Mat& true_depth = {});

  // Writes the truth, sorted by time, and completes the lists.
  void finish(const Trajectory& truth);

  // Another small text file beside the lists, such as simulation.json.
  void write_text(const std::string& name, const std::string& text);

 private:
  std::filesystem::path folder_;
  Camera camera_;
  DepthStorage storage_;
  cv::Mat range_per_z_;  // CV_32F, empty where z is stored
  double last_time_ = -1;
  std::ofstream rgb_list_, depth_list_, true_depth_list_;

  void write_depth(const std::string& folder, const std::string& stamp, const cv::Mat& depth,
                   std::ofstream& list);
};

}  // namespace framewise
