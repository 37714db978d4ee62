// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <stdexcept>

#include "framewise/image/depth.h"
#include "framewise/io/file_lists.h"
#include "framewise/io/image_files.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

// FNV-1a, 64 bit: tells recordings apart, keeps no secrets.
class Fingerprint {
 public:
  void add(const std::string& text) {
    for (const unsigned char c : text) hash_ = (hash_ ^ c) * 0x100000001b3ull;
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

std::string existing_file(const fs::path& list, const ListedFile& listed, Fingerprint& fingerprint) {
  const fs::path path = list.parent_path() / listed.file;
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) throw InputError(list, listed.line, "", fmt::format("'{}'", listed.file), "a file that exists");
  fingerprint.add(fmt::format("{} {} {}\n", listed.time, listed.file, size));
  return path.string();
}

std::vector<FrameFiles> frames_from_associations(const fs::path& list, Fingerprint& fingerprint) {
  std::vector<FrameFiles> frames;
  for (const AssociatedFiles& pair : read_association_list(list)) {
    const std::string color = existing_file(list, pair.color, fingerprint);
    frames.push_back({pair.color.time, color, existing_file(list, pair.depth, fingerprint)});
  }
  return frames;
}

std::vector<FrameFiles> frames_from_lists(const fs::path& folder, double max_difference,
                                          Fingerprint& fingerprint) {
  const fs::path color_list = folder / "rgb.txt", depth_list = folder / "depth.txt";
  const auto colors = read_file_list(color_list);
  const auto depths = fs::exists(depth_list) ? read_file_list(depth_list) : std::vector<ListedFile>();
  const auto times_of = [](const std::vector<ListedFile>& files) {
    std::vector<double> times;
    for (const ListedFile& file : files) times.push_back(file.time);
    return times;
  };
  const auto partner = associate_by_time(times_of(colors), times_of(depths), max_difference);
  if (!depths.empty() && std::all_of(partner.begin(), partner.end(), [](int j) { return j < 0; }))
    throw InputError(depth_list, 0, "",
                     fmt::format("times {} to {} s", depths.front().time, depths.back().time),
                     fmt::format("times within {} s of rgb.txt's, {} to {} s", max_difference,
                                 colors.front().time, colors.back().time));

  std::vector<FrameFiles> frames;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    FrameFiles frame{colors[i].time, existing_file(color_list, colors[i], fingerprint), {}};
    if (partner[i] >= 0) frame.depth = existing_file(depth_list, depths[partner[i]], fingerprint);
    frames.push_back(std::move(frame));
  }
  return frames;
}

// The benchmark's three cameras are told by the folder's name or by the line "# file:
// 'rgbd_dataset_freiburgN_…'".
std::optional<std::string> tum_camera_name(const fs::path& folder) {
  const std::regex pattern("freiburg[123]");
  std::smatch found;
  const std::string folder_name = folder.filename().string();
  if (std::regex_search(folder_name, found, pattern)) return found.str();
  for (const char* list : {"rgb.txt", "depth.txt", "groundtruth.txt"}) {
    std::ifstream file(folder / list);
    std::string line;
    while (std::getline(file, line) && line.starts_with('#'))
      if (std::regex_search(line, found, pattern)) return found.str();
  }
  return std::nullopt;
}

std::pair<CameraFile, std::string> find_calibration(const fs::path& folder, const DatasetOptions& options) {
  for (const fs::path& file : {options.camera_file, folder / "camera.yaml"})
    if (!file.empty() && (file == options.camera_file || fs::exists(file)))
      return {read_camera_file(file), file.filename().string()};
  if (const auto name = tum_camera_name(folder)) return {*tum_calibration(*name), *name};
  throw InputError(folder, 0, "calibration",
                   "neither camera.yaml nor a name of the TUM benchmark (freiburg1, 2, 3)",
                   "a camera file: --camera FILE");
}

void check_truth(const fs::path& file, const Trajectory& truth, const std::vector<FrameFiles>& frames) {
  if (truth.times.front() <= frames.back().time && truth.times.back() >= frames.front().time) return;
  throw InputError(
      file, 0, "", fmt::format("times {} to {} s", truth.times.front(), truth.times.back()),
      fmt::format("times that overlap the images', {} to {} s", frames.front().time, frames.back().time));
}

fs::path association_file(const fs::path& folder) {
  for (const char* name : {"associations.txt", "association.txt", "associate.txt"})
    if (fs::exists(folder / name)) return folder / name;
  return {};
}

}  // namespace

void DatasetOptions::check() const {
  const auto positive = [](const char* name, double value) {
    if (!(value > 0) || !std::isfinite(value))
      throw std::invalid_argument(fmt::format("{}: found {}, expected more than 0", name, value));
  };
  if (depth_factor) positive("depth-factor", *depth_factor);
  if (depth_max) positive("depth-max", *depth_max);
  positive("max-time-difference", max_time_difference);
  positive("max-truth-gap", max_truth_gap);
}

Dataset open_dataset(const fs::path& folder, const DatasetOptions& options) {
  options.check();
  if (!fs::is_directory(folder))
    throw InputError(folder, 0, "", "no folder", "a data set in TUM RGB-D layout");
  if (!fs::exists(folder / "rgb.txt") && association_file(folder).empty())
    throw InputError(folder, 0, "", "no rgb.txt",
                     "a data set in TUM RGB-D layout (rgb.txt, depth.txt, groundtruth.txt)");

  Dataset dataset;
  Fingerprint fingerprint;
  dataset.folder = folder;
  dataset.name = fs::weakly_canonical(folder).filename().string();
  dataset.format = "tum";
  std::tie(dataset.calibration, dataset.calibration_source) = find_calibration(folder, options);
  dataset.calibration.depth_factor = options.depth_factor.value_or(dataset.calibration.depth_factor);
  dataset.calibration.depth_max = options.depth_max.value_or(dataset.calibration.depth_max);

  const fs::path associations = association_file(folder);
  dataset.frames = associations.empty() ? frames_from_lists(folder, options.max_time_difference, fingerprint)
                                        : frames_from_associations(associations, fingerprint);
  dataset.frames_with_depth = std::count_if(dataset.frames.begin(), dataset.frames.end(),
                                            [](const auto& f) { return !f.depth.empty(); });
  dataset.fingerprint = fingerprint.text();

  if (const fs::path truth_file = folder / "groundtruth.txt"; fs::exists(truth_file)) {
    dataset.truth = read_trajectory(truth_file, TrajectoryFormat::kTum).trajectory;
    check_truth(truth_file, dataset.truth, dataset.frames);
  }
  return dataset;
}

Frame read_frame(const FrameFiles& files, const CameraFile& calibration,
                 const std::string& calibration_source) {
  const Camera& camera = calibration.camera;
  const auto check_size = [&](const fs::path& path, const cv::Mat& image) {
    if (image.cols == camera.width && image.rows == camera.height) return;
    throw InputError(
        path, 0, "size", fmt::format("{} x {}", image.cols, image.rows),
        fmt::format("{} x {} as in the calibration ({})", camera.width, camera.height, calibration_source));
  };
  Frame frame;
  frame.time = files.time;
  frame.gray = read_gray(files.color);
  check_size(files.color, frame.gray);
  if (!files.depth.empty()) {
    const cv::Mat raw = read_depth_file(files.depth);
    check_size(files.depth, raw);
    frame.depth = depth_from_raw(raw, calibration.depth_factor, calibration.depth_max);
    if (calibration.depth_type == DepthType::kRange)
      frame.depth = z_from_range(frame.depth, calibration.camera);
  }
  return frame;
}

Frame load_frame(const Dataset& dataset, std::size_t index) {
  return read_frame(dataset.frames.at(index), dataset.calibration, dataset.calibration_source);
}

Trajectory truth_at_frames(const Dataset& dataset, double max_gap) {
  Trajectory truth;
  for (const FrameFiles& frame : dataset.frames)
    if (const auto pose = pose_at(dataset.truth, frame.time, max_gap)) truth.add(frame.time, *pose);
  return truth;
}

}  // namespace framewise
