// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Renders of Blender: a camera path beside folders of images that are called by their frames' numbers.
#include <fmt/format.h>

#include <map>

#include "framewise/io/blender_path.h"
#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kBlenderRate = 24;  // Blender's own

fs::path path_file(const fs::path& folder) {
  return first_existing(folder, {"camera_path.csv", "camera_path.json", "camera_path.txt", "transforms.json",
                                 "transforms_train.json"});
}

std::string recognise_blender(const fs::path& folder) {
  const fs::path file = path_file(folder);
  return file.empty() ? "" : "it has " + file.filename().string();
}

// The names of a folder's images by the numbers in them.
std::map<long, std::string> by_number(const fs::path& folder, const std::vector<std::string>& extensions) {
  std::map<long, std::string> names;
  if (folder.empty()) return names;
  for (const std::string& name : files_in(folder, extensions))
    if (const auto number = number_in(name); number && !names.emplace(*number, name).second)
      throw InputError(folder, 0, "", fmt::format("'{}' and '{}'", names[*number], name),
                       "one image a frame");
  return names;
}

struct Renders {
  fs::path color_folder, depth_folder;
  std::map<long, std::string> color, depth;
};

Renders find_renders(const fs::path& folder) {
  Renders renders;
  renders.color_folder = first_existing(folder, {"rgb", "color", "colour", "images", "render", "train"});
  renders.depth_folder = first_existing(folder, {"depth", "range"});
  renders.color = by_number(renders.color_folder, image_extensions());
  renders.depth = by_number(renders.depth_folder, depth_extensions());
  if (renders.color.empty() && renders.depth.empty())
    throw InputError(folder, 0, "", "no images in rgb, color, images, depth or range",
                     "images called by their frames' numbers");
  return renders;
}

void add_render(Dataset& dataset, const Renders& renders, long number, double time,
                Fingerprint& fingerprint) {
  FrameFiles frame;
  frame.time = time;
  if (const auto color = renders.color.find(number); color != renders.color.end())
    frame.color = existing_file(renders.color_folder, color->second, time, fingerprint);
  if (const auto depth = renders.depth.find(number); depth != renders.depth.end())
    frame.depth = existing_file(renders.depth_folder, depth->second, time, fingerprint);
  dataset.frames.push_back(std::move(frame));
}

Dataset open_blender(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "renders of Blender");
  const fs::path file = path_file(folder);
  if (file.empty()) throw InputError(folder, 0, "", "no camera_path.csv", "a camera path of Blender");
  const BlenderPath path = read_blender_path(file);
  const Renders renders = find_renders(folder);
  Dataset dataset = dataset_of(folder);
  CameraFile otherwise = depth_of_unknown_unit();
  if (renders.depth_folder.filename() == "range") otherwise.depth_type = DepthType::kRange;
  calibrate(
      dataset, options, otherwise,
      [&]() -> std::optional<NamedCalibration> {
        if (!path.camera) return std::nullopt;
        CameraFile calibration = otherwise;
        calibration.camera = *path.camera;
        return NamedCalibration(calibration, file.filename().string());
      },
      "a lens in " + file.filename().string());

  std::map<long, int> numbers;  // of all frames, in order
  for (const auto* names : {&renders.color, &renders.depth})
    for (const auto& [number, name] : *names) numbers[number];
  const double rate = options.fps.value_or(path.fps.value_or(kBlenderRate));
  dataset.times_source = fmt::format("frames' numbers, {} a second", rate);
  Fingerprint fingerprint;
  for (const auto& [number, unused] : numbers) {
    const double time = static_cast<double>(number - numbers.begin()->first) / rate;
    add_render(dataset, renders, number, time, fingerprint);
    if (const auto pose = path.world_from_cam.find(number); pose != path.world_from_cam.end())
      dataset.truth.add(time, pose->second);
  }
  if (dataset.truth.empty())
    throw InputError(
        file, 0, "frame",
        fmt::format("{} to {}", path.world_from_cam.begin()->first, path.world_from_cam.rbegin()->first),
        fmt::format("the images' numbers, {} to {}", numbers.begin()->first, numbers.rbegin()->first));
  dataset.truth_source = file.filename().string();
  dataset.fingerprint = fingerprint.text();
  expect_depth_unit(dataset);
  return dataset;
}

}  // namespace

DatasetReader blender_reader() {
  return {"blender", "camera_path.csv or transforms.json, with rgb, depth or range", recognise_blender,
          open_blender};
}

}  // namespace framewise
