// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framewise/geometry/gyroscope.h"
#include "framewise/geometry/trajectory.h"
#include "framewise/image/frame.h"
#include "framewise/io/camera_file.h"

namespace framewise {

struct DatasetOptions {
  std::filesystem::path camera_file;   // empty: camera.yaml in the folder, else the calibration known by name
  std::optional<double> depth_factor;  // overrides the calibration's
  std::optional<double> depth_max;     // m, likewise
  double max_time_difference = 0.02;   // colour and depth farther apart are not one frame (s)
  double max_truth_gap = 0.1;          // no truth is interpolated across a hole longer than this (s)

  // Throws std::invalid_argument that names the value.
  void check() const;
};

struct FrameFiles {
  double time = 0;  // of the colour image (s)
  std::string color;
  std::string depth;  // empty where no depth image is close enough in time
};

// A recording on disk: what there is, nothing decoded.
struct Dataset {
  std::string name, format;
  std::filesystem::path folder;
  CameraFile calibration;
  std::string calibration_source;  // the file, or the name the calibration is known by
  std::vector<FrameFiles> frames;  // in time order
  std::size_t frames_with_depth = 0;
  Gyroscope gyroscope;      // empty where there is none
  Trajectory truth;         // as recorded; empty where there is none
  std::string fingerprint;  // of the lists and the files' sizes, 16 hexadecimal digits
};

// Opens a folder in TUM RGB-D layout: rgb.txt, depth.txt (optional), groundtruth.txt (optional),
// associations.txt (optional: then it alone says which files are a frame).
// Throws InputError that names the file, the line, what was found and what was expected.
Dataset open_dataset(const std::filesystem::path& folder, const DatasetOptions& options);

// Decodes images that are one frame: gray and, where `depth` names a file, depth. Throws InputError; images
// of another size than the camera's are refused.
Frame read_frame(const FrameFiles& files, const CameraFile& calibration,
                 const std::string& calibration_source);

// Decodes a frame: gray and, where there is any, depth. Throws InputError; images of two sizes are refused.
Frame load_frame(const Dataset& dataset, std::size_t index);

// The truth at the frames' times (linear and slerp): one entry for each frame the truth covers.
Trajectory truth_at_frames(const Dataset& dataset, double max_gap);

}  // namespace framewise
