// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/trajectory.h"
#include "framewise/image/frame.h"

namespace framewise {

// Writes a recording in the layout of the TUM RGB-D benchmark, frame by frame:
//   rgb.txt, depth.txt     `time file`, times with six decimals
//   rgb/*.png              8-bit colour
//   depth/*.png            16-bit z, metres times depth_factor, 0 where unknown or out of the 16 bits
//   groundtruth.txt        `time tx ty tz qx qy qz qw`, world_from_cam, every digit of a double
//   camera.yaml            the camera, as docs say, with depth_factor
// A recording that ends early is complete up to its last frame once finish() was called.
// Failures to write throw std::runtime_error naming the file.
class TumWriter {
 public:
  // Creates the folder and what is missing above it. Throws std::invalid_argument where it holds a recording
  // already.
  TumWriter(const std::filesystem::path& folder, const Camera& camera, double depth_factor = 5000);

  // Needs colour and depth of the camera's size; times must grow by at least a microsecond.
  void add(const Frame& frame);

  // Writes the truth, sorted by time, and completes the lists.
  void finish(const Trajectory& truth);

  // Another small text file beside the lists, such as simulation.json.
  void write_text(const std::string& name, const std::string& text);

 private:
  std::filesystem::path folder_;
  Camera camera_;
  double depth_factor_;
  double last_time_ = -1;
  std::ofstream rgb_list_, depth_list_;
};

}  // namespace framewise
