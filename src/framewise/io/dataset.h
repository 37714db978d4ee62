// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framewise/geometry/gyroscope.h"
#include "framewise/geometry/trajectory.h"
#include "framewise/image/frame.h"
#include "framewise/image/registration.h"
#include "framewise/io/camera_file.h"

namespace framewise {

class VideoFile;

struct DatasetOptions {
  std::string format;                  // a name of dataset_formats(); empty: recognised
  std::filesystem::path camera_file;   // empty: camera.yaml in the folder, else the format's own calibration
  bool needs_camera = true;            // false: a recording without any calibration is opened all the same
  bool register_depth = true;          // false: depth is taken as it is where its camera is another one
  std::string depth_type;              // z or range; overrides the calibration's
  std::optional<double> depth_factor;  // raw units in a metre, likewise
  std::optional<double> depth_max;     // m, likewise
  std::optional<double> fps;           // frames a second where the recording has no stamps
  double max_time_difference = 0.02;   // colour and depth farther apart are not one frame (s)
  double max_truth_gap = 0.1;          // no truth is interpolated across a hole longer than this (s)

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// A path object takes a kilobyte, and there are many frames: strings.
struct FrameFiles {
  double time = 0;         // of the colour image, else of the depth image (s)
  std::string color;       // empty in recordings of depth alone; of a video the video's file
  std::string depth;       // empty where no depth image is close enough in time
  double depth_delay = 0;  // the depth image's time less the colour image's (s)
};

// A recording on disk: what there is, nothing decoded.
struct Dataset {
  std::string name, format;
  std::string recognised_by;  // why it is this format: a sentence without its full stop
  std::filesystem::path folder;
  CameraFile calibration;
  std::string calibration_source;  // the file, or the name the calibration is known by; empty: none is known
  std::string times_source;        // where the frames' times are from
  std::vector<FrameFiles> frames;  // in time order
  std::size_t frames_with_color = 0, frames_with_depth = 0;
  std::size_t unmatched_depth = 0;  // depth images that belong to no frame
  Trajectory truth;                 // world_from_cam of the calibration's camera; empty where there is none
  std::string truth_source;
  double truth_norm_error = 0;  // largest distance of a quaternion's length from 1 in that file
  Gyroscope gyroscope;          // empty where there is none
  std::string fingerprint;      // of the lists and the files' sizes, 16 hexadecimal digits

  std::shared_ptr<const DepthRegistration> registration;  // where calibration.depth_camera is
  std::shared_ptr<VideoFile> video;                       // where the frames are a video's

  bool has_camera() const { return !calibration_source.empty(); }
};

// Names of the formats that are known: "tum", "putkk", "icl-nuim", "7-scenes", "kitti", "kitti-depth",
// "euroc", "blender", "hololens", "depth", "images", "video". docs/datasets.md describes each.
std::vector<std::string> dataset_formats();

// Opens a recording: a folder of a format that is recognised (or named by the options), or a video file.
// Poses and axes are converted to world_from_cam of a camera that looks along z with y down. Throws
// InputError that names the file, the line, what was found and what was expected.
Dataset open_dataset(const std::filesystem::path& path, const DatasetOptions& options);

// Decodes images that are one frame: gray where `color` names a file, depth where `depth` does. Throws
// InputError; images of another size than the camera's are refused.
Frame read_frame(const FrameFiles& files, const CameraFile& calibration,
                 const std::string& calibration_source);

// Decodes a frame: gray and depth as far as there are any. May be called from any thread. Throws InputError;
// images of two sizes are refused.
Frame load_frame(const Dataset& dataset, std::size_t index);

// The same without colour, which is not read.
Frame load_depth(const Dataset& dataset, std::size_t index);

// The truth at the frames' times (linear and slerp): one entry for each frame the truth covers.
Trajectory truth_at_frames(const Dataset& dataset, double max_gap);

}  // namespace framewise
