// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "framewise/image/depth.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/image_files.h"
#include "framewise/io/input_error.h"
#include "framewise/io/video_file.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

// The more a layout says about itself, the earlier it is tried.
const std::array<DatasetReader, 12>& readers() {
  static const std::array<DatasetReader, 12> all = {
      euroc_reader(),       kitti_reader(), seven_scenes_reader(), icl_nuim_reader(),
      putkk_reader(),       tum_reader(),   blender_reader(),      hololens_reader(),
      kitti_depth_reader(), depth_reader(), images_reader(),       video_reader()};
  return all;
}

const DatasetReader& reader_named(const std::string& name) {
  for (const DatasetReader& reader : readers())
    if (name == reader.name) return reader;
  throw std::invalid_argument(
      fmt::format("format: found '{}', expected one of {}", name, fmt::join(dataset_formats(), ", ")));
}

std::string all_layouts() {
  std::string text;
  for (const DatasetReader& reader : readers())
    text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", reader.name, reader.layout);
  return text;
}

struct Recognised {
  const DatasetReader* reader;
  std::string reason;
};

Recognised recognise(const fs::path& path, const DatasetOptions& options) {
  if (!options.format.empty()) return {&reader_named(options.format), "--format says so"};
  if (!fs::exists(path)) throw InputError(path, 0, "", "no folder or file", "a data set");
  for (const DatasetReader& reader : readers())
    if (std::string reason = reader.recognise(path); !reason.empty()) return {&reader, std::move(reason)};
  throw InputError(path, 0, "", "no data set of a known format", "one of: " + all_layouts());
}

void check_size(const fs::path& path, const cv::Mat& image, const Camera& camera, const std::string& source) {
  if (source.empty() || (image.cols == camera.width && image.rows == camera.height)) return;
  throw InputError(path, 0, "size", fmt::format("{} x {}", image.cols, image.rows),
                   fmt::format("{} x {} as in the calibration ({})", camera.width, camera.height, source));
}

cv::Mat read_depth(const std::string& path, const CameraFile& calibration, const std::string& source,
                   const DepthRegistration* registration) {
  const cv::Mat raw = read_depth_file(path);
  check_size(path, raw, calibration.camera_of_depth(), source);
  cv::Mat depth = depth_from_raw(raw, calibration.depth_factor, calibration.depth_max);
  if (calibration.depth_type == DepthType::kRange && !source.empty())
    depth = z_from_range(depth, calibration.camera_of_depth());
  return registration ? (*registration)(depth) : depth;
}

Frame read_frame(const FrameFiles& files, const CameraFile& calibration, const std::string& source,
                 const DepthRegistration* registration) {
  Frame frame;
  frame.time = files.time;
  if (!files.color.empty()) {
    frame.gray = read_gray(files.color);
    check_size(files.color, frame.gray, calibration.camera, source);
  }
  if (!files.depth.empty()) frame.depth = read_depth(files.depth, calibration, source, registration);
  frame.depth_delay = files.depth_delay;
  return frame;
}

std::shared_ptr<const DepthRegistration> registration_of(const CameraFile& calibration) {
  if (!calibration.depth_camera) return nullptr;
  return std::make_shared<DepthRegistration>(calibration.camera, *calibration.depth_camera);
}

}  // namespace

void DatasetOptions::check() const {
  const auto positive = [](const char* name, double value) {
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(fmt::format("{}: found {}, expected more than 0", name, value));
  };
  if (!format.empty()) reader_named(format);
  if (!depth_type.empty() && !depth_type_from_name(depth_type))
    throw std::invalid_argument(fmt::format("depth-type: found '{}', expected z or range", depth_type));
  if (depth_factor) positive("depth-factor", *depth_factor);
  if (depth_max) positive("depth-max", *depth_max);
  if (fps) positive("fps", *fps);
  positive("max-time-difference", max_time_difference);
  positive("max-truth-gap", max_truth_gap);
}

std::vector<std::string> dataset_formats() {
  std::vector<std::string> names;
  for (const DatasetReader& reader : readers()) names.push_back(reader.name);
  return names;
}

Dataset open_dataset(const fs::path& path, const DatasetOptions& options) {
  options.check();
  const Recognised found = recognise(path, options);
  Dataset dataset = found.reader->open(path, options);
  dataset.format = found.reader->name;
  dataset.recognised_by = found.reason;
  const auto count = [&](auto member) {
    return static_cast<std::size_t>(std::count_if(dataset.frames.begin(), dataset.frames.end(),
                                                  [&](const FrameFiles& f) { return !(f.*member).empty(); }));
  };
  dataset.frames_with_color = count(&FrameFiles::color);
  dataset.frames_with_depth = count(&FrameFiles::depth);
  if (dataset.frames_with_depth > 0) dataset.registration = registration_of(dataset.calibration);
  return dataset;
}

Frame read_frame(const FrameFiles& files, const CameraFile& calibration,
                 const std::string& calibration_source) {
  const auto registration = files.depth.empty() ? nullptr : registration_of(calibration);
  return read_frame(files, calibration, calibration_source, registration.get());
}

Frame load_frame(const Dataset& dataset, std::size_t index) {
  FrameFiles files = dataset.frames.at(index);
  if (dataset.video) files.color.clear();
  Frame frame =
      read_frame(files, dataset.calibration, dataset.calibration_source, dataset.registration.get());
  if (dataset.video) {
    frame.gray = dataset.video->gray(index);
    check_size(dataset.frames[index].color, frame.gray, dataset.calibration.camera,
               dataset.calibration_source);
  }
  return frame;
}

Frame load_depth(const Dataset& dataset, std::size_t index) {
  FrameFiles files = dataset.frames.at(index);
  files.color.clear();
  return read_frame(files, dataset.calibration, dataset.calibration_source, dataset.registration.get());
}

Trajectory truth_at_frames(const Dataset& dataset, double max_gap) {
  Trajectory truth;
  for (const FrameFiles& frame : dataset.frames)
    if (const auto pose = pose_at(dataset.truth, frame.time, max_gap)) truth.add(frame.time, *pose);
  return truth;
}

}  // namespace framewise
