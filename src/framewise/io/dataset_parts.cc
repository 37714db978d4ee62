// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/dataset_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "framewise/io/image_files.h"
#include "framewise/io/input_error.h"

namespace framewise {

namespace fs = std::filesystem;

void Fingerprint::add(const std::string& text) {
  for (const unsigned char c : text) hash_ = (hash_ ^ c) * 0x100000001b3ull;
}

std::string Fingerprint::text() const { return fmt::format("{:016x}", hash_); }

void calibrate(Dataset& dataset, const DatasetOptions& options, const CameraFile& otherwise,
               const std::function<std::optional<NamedCalibration>()>& known,
               const std::string& expected_by_name) {
  const fs::path own = dataset.folder / "camera.yaml";
  const fs::path file = !options.camera_file.empty() ? options.camera_file
                        : fs::exists(own)            ? own
                                                     : fs::path();
  dataset.calibration = otherwise;
  if (!file.empty()) {
    dataset.calibration = read_camera_file(file, otherwise);
    dataset.calibration_source = file.filename().string();
  } else if (const auto named = known()) {
    std::tie(dataset.calibration, dataset.calibration_source) = *named;
  } else if (options.needs_camera) {
    throw InputError(dataset.folder, 0, "calibration",
                     "no camera.yaml" + (expected_by_name.empty() ? "" : ", nor " + expected_by_name),
                     "a camera file: --camera FILE");
  }
  override_depth(dataset.calibration, options.depth_type, options.depth_factor, options.depth_max);
  if (!options.register_depth) dataset.calibration.depth_camera.reset();
}

Dataset dataset_of(const fs::path& folder) {
  Dataset dataset;
  dataset.folder = folder;
  dataset.name = folder_name(folder);
  return dataset;
}

std::string existing_file(const fs::path& folder, const std::string& file, double time,
                          Fingerprint& fingerprint, const fs::path& list, int line) {
  std::string path = (folder / file).string();
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error)
    throw InputError(list.empty() ? folder : list, static_cast<std::size_t>(line), "",
                     fmt::format("'{}'", file), "a file that exists");
  fingerprint.add(fmt::format("{} {} {}\n", time, file, size));
  return path;
}

void check_truth(const fs::path& file, const Trajectory& truth, const std::vector<FrameFiles>& frames) {
  if (truth.times.front() <= frames.back().time && truth.times.back() >= frames.front().time) return;
  throw InputError(
      file, 0, "", fmt::format("times {} to {} s", truth.times.front(), truth.times.back()),
      fmt::format("times that overlap the images', {} to {} s", frames.front().time, frames.back().time));
}

void expect_folder(const fs::path& path, const char* expected) {
  if (!fs::is_directory(path)) throw InputError(path, 0, "", "no folder", expected);
}

fs::path whole_path(const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(folder));
  return whole.has_filename() ? whole : whole.parent_path();  // "a/" is a folder as well
}

std::string folder_name(const fs::path& folder) { return whole_path(folder).filename().string(); }

CameraFile depth_of_unknown_unit() {
  CameraFile file;
  file.depth_factor = std::numeric_limits<double>::infinity();
  file.depth_max = 1000;
  return file;
}

void expect_depth_unit(const Dataset& dataset) {
  if (std::isfinite(dataset.calibration.depth_factor)) return;
  const auto first = std::find_if(dataset.frames.begin(), dataset.frames.end(),
                                  [](const FrameFiles& frame) { return !frame.depth.empty(); });
  if (first == dataset.frames.end() || read_depth_file(first->depth).type() != CV_16UC1) return;
  throw InputError(first->depth, 0, "depth", "16-bit numbers of no known unit",
                   "--depth-factor F (raw units in a metre), or --depth-type range --depth-max M");
}

std::pair<int, int> image_size(const fs::path& file) {
  const cv::Mat image = read_image(file);
  return {image.cols, image.rows};
}

}  // namespace framewise
