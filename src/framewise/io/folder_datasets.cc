// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Folders of images without lists: photographs, or depth alone.
#include <fmt/format.h>

#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/frame_times.h"
#include "framewise/io/image_files.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kVideoRate = 30;

// The first image, read; an image with one channel of 16 bits or of floats is depth.
bool holds_depth(const fs::path& folder) {
  const auto names = files_in(folder, depth_extensions());
  if (names.empty()) return false;
  try {
    const cv::Mat image = read_image(folder / names.front());
    return image.type() == CV_16UC1 || image.type() == CV_32FC1;
  } catch (const InputError&) {
    return false;  // the reader that is chosen then says what is wrong
  }
}

// The folder itself, or the one folder inside it that is called so.
fs::path images_within(const fs::path& folder, const std::vector<std::string>& extensions,
                       const std::vector<std::string>& names) {
  if (!files_in(folder, extensions).empty()) return folder;
  const fs::path inside = first_existing(folder, names);
  return inside.empty() || files_in(inside, extensions).empty() ? fs::path() : inside;
}

fs::path depth_folder(const fs::path& folder) {
  return images_within(folder, depth_extensions(), {"depth", "range"});
}

fs::path photo_folder(const fs::path& folder) {
  return images_within(folder, image_extensions(), {"images", "image", "rgb", "color", "colour", "data"});
}

void add_frames(Dataset& dataset, const fs::path& images, const std::vector<std::string>& names,
                std::string FrameFiles::*kind, const std::optional<double>& fps, double assumed_fps) {
  const FrameTimes times = frame_times(dataset.folder / "times.txt", names, fps, assumed_fps);
  dataset.times_source = times.source;
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < names.size(); ++i) {
    FrameFiles frame;
    frame.time = times.times[i];
    frame.*kind = existing_file(images, names[i], frame.time, fingerprint);
    dataset.frames.push_back(std::move(frame));
  }
  dataset.fingerprint = fingerprint.text();
}

std::string recognise_images(const fs::path& folder) {
  const fs::path images = photo_folder(folder);
  if (images.empty()) return "";
  return fmt::format("it has {} images and no lists", files_in(images, image_extensions()).size());
}

Dataset open_images(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a folder of images");
  const fs::path images = photo_folder(folder);
  if (images.empty()) throw InputError(folder, 0, "", "no images", "a folder of .png, .jpg, … files");
  Dataset dataset = dataset_of(folder);
  calibrate(
      dataset, options, {}, [] { return std::nullopt; }, "");
  add_frames(dataset, images, files_in(images, image_extensions()), &FrameFiles::color, options.fps,
             kVideoRate);
  return dataset;
}

std::string recognise_depth(const fs::path& folder) {
  const fs::path images = depth_folder(folder);
  if (images.empty() || !holds_depth(images)) return "";
  return fmt::format("{} has one channel of 16 bits or floats", files_in(images, depth_extensions()).front());
}

Dataset open_depth_folder(const fs::path& folder, const DatasetOptions& options, const CameraFile& otherwise,
                          double assumed_fps) {
  expect_folder(folder, "a folder of depth images");
  const fs::path images = depth_folder(folder);
  if (images.empty())
    throw InputError(folder, 0, "", "no depth images", "a folder of .png, .tiff or .exr files");
  Dataset dataset = dataset_of(folder);
  calibrate(
      dataset, options, otherwise, [] { return std::nullopt; }, "");
  add_frames(dataset, images, files_in(images, depth_extensions()), &FrameFiles::depth, options.fps,
             assumed_fps);
  expect_depth_unit(dataset);
  return dataset;
}

Dataset open_depth(const fs::path& folder, const DatasetOptions& options) {
  CameraFile otherwise = depth_of_unknown_unit();
  const fs::path images = depth_folder(folder);
  if (!images.empty() && folder_name(images).find("range") != std::string::npos)
    otherwise.depth_type = DepthType::kRange;
  return open_depth_folder(folder, options, otherwise, kVideoRate);
}

// Uhrig et al., Sparsity invariant CNNs, 3DV 2017: value / 256, 0 unknown.
std::string recognise_kitti_depth(const fs::path& folder) {
  const std::string whole = whole_path(folder).string();
  for (const char* name : {"proj_depth", "groundtruth_depth", "velodyne_raw"})
    if (whole.find(name) != std::string::npos && !files_in(folder, {".png"}).empty())
      return fmt::format("its path names {}", name);
  return "";
}

Dataset open_kitti_depth(const fs::path& folder, const DatasetOptions& options) {
  CameraFile otherwise;
  otherwise.depth_factor = 256;
  otherwise.depth_max = 200;  // a LiDAR's reach
  return open_depth_folder(folder, options, otherwise, 10);
}

}  // namespace

DatasetReader images_reader() { return {"images", "a folder of images", recognise_images, open_images}; }

DatasetReader depth_reader() {
  return {"depth", "a folder of 16-bit PNG, TIFF or EXR depth images", recognise_depth, open_depth};
}

DatasetReader kitti_depth_reader() {
  return {"kitti-depth", "a folder of PNGs below proj_depth", recognise_kitti_depth, open_kitti_depth};
}

}  // namespace framewise
