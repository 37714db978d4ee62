// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/imu_reading.h"
#include "framewise/geometry/trajectory.h"
#include "framewise/image/depth_rays.h"
#include "framewise/image/frame.h"

namespace framewise {

// How depth becomes numbers of 16 bits.
struct DepthStorage {
  double factor = 5000;            // raw units in a metre
  DepthType type = DepthType::kZ;  // kRange: what is written is the distance along the pixel's ray
  std::optional<double> max;       // the sensor's reach, written beside it where it is given (m)
};

// Writes a recording frame by frame in the layout of a benchmark; the classes that derive from it say which
// files. A recording that ends early is complete up to its last frame once finish() was called. Failures to
// write throw std::runtime_error naming the file.
class RecordingWriter {
 public:
  virtual ~RecordingWriter() = default;
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  // Needs colour and depth of the camera's size, z in metres whatever is stored; times must grow by at least
  // a microsecond. True depth, without a sensor's faults, comes with all frames or with none.
  void add(const Frame& frame, const cv::Mat& true_depth = {});

  // Writes the truth, sorted by time, and completes the lists.
  virtual void finish(const Trajectory& truth) = 0;

  // What an inertial unit at the camera read, and without its faults.
  virtual void write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth,
                         double rate_hz) = 0;

  // Another small text file in the folder, such as simulation.json.
  void write_text(const std::string& name, const std::string& text);

 protected:
  // Throws std::invalid_argument for a camera or a storage that makes no sense, and where one of these files
  // is in the folder already.
  RecordingWriter(const std::filesystem::path& folder, const Camera& camera, const DepthStorage& storage,
                  const std::vector<std::string>& files);

  virtual void write_frame(const Frame& frame, const cv::Mat& true_depth) = 0;

  // The bytes of depth in metres, CV_16U; ranges where those are stored.
  cv::Mat raw_depth(const cv::Mat& depth) const;

  const std::filesystem::path folder_;
  const Camera camera_;
  const DepthStorage storage_;

 private:
  cv::Mat range_per_z_;  // CV_32F, empty where z is stored
  double last_time_ = -1;
  int frames_ = 0;
  bool has_true_depth_ = false;
};

// tum, euroc, kitti-depth.
const std::vector<std::string>& recording_layouts();

// A writer by the name of its layout, of so many frames a second; creates the folder and what is missing
// above it. Throws std::invalid_argument for a name that is none, for a camera or depth that the layout
// cannot hold, and where the folder holds a recording already.
std::unique_ptr<RecordingWriter> recording_writer(const std::string& layout,
                                                  const std::filesystem::path& folder, const Camera& camera,
                                                  const DepthStorage& storage, double rate_hz);

}  // namespace framewise
