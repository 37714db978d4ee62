// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Folders of colour and depth images with a list of poses beside them, as HoloLens recorders write them: the
// n-th image of each folder and the n-th row of poses.txt, 4x4 world_from_camera, are a frame.
#include <fmt/format.h>

#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/frame_times.h"
#include "framewise/io/input_error.h"
#include "framewise/io/pose_rows.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kHololensRate = 30;

fs::path color_folder(const fs::path& folder) {
  return first_existing(folder, {"color", "colour", "rgb", "images", "pv"});
}

std::string recognise_hololens(const fs::path& folder) {
  if (!fs::exists(folder / "poses.txt")) return "";
  const fs::path color = color_folder(folder);
  return fs::is_directory(color) ? fmt::format("it has {} and poses.txt", color.filename().string()) : "";
}

std::vector<Pose> read_poses(const fs::path& file, std::size_t frames) {
  const NumberRows rows(file, "a 4x4 matrix a line");
  if (rows.size() != frames)
    throw InputError(file, 0, "poses", std::to_string(rows.size()),
                     fmt::format("{}, one for each image", frames));
  std::vector<Pose> poses;
  for (const NumberRow& row : rows) {
    rows.expect_columns(row, row.fields.size() == 16, "16 (a 4x4 matrix, row by row)");
    const std::array<double, 4> last = {rows.number(row, 12, "column 13"), rows.number(row, 13, "column 14"),
                                        rows.number(row, 14, "column 15"), rows.number(row, 15, "column 16")};
    if (last != std::array<double, 4>{0, 0, 0, 1})
      throw InputError(file, row.line, "last row", fmt::format("{}", fmt::join(last, " ")),
                       "0 0 0 1 (is the matrix written column by column?)");
    poses.push_back(pose_of_matrix(rows, row));
  }
  return poses;
}

std::vector<std::string> depth_images(const fs::path& folder, std::size_t frames) {
  const auto names = files_in(folder, depth_extensions());
  if (!names.empty() && names.size() != frames)
    throw InputError(folder, 0, "images", std::to_string(names.size()),
                     fmt::format("{}, one for each colour image", frames));
  return names;
}

Dataset open_hololens(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "colour and depth folders with poses.txt");
  const fs::path color = color_folder(folder);
  const auto names = color.empty() ? std::vector<std::string>() : files_in(color, image_extensions());
  if (names.empty())
    throw InputError(folder, 0, "", "no images in color", "colour and depth folders with poses.txt");
  const auto depths = depth_images(folder / "depth", names.size());
  const std::vector<Pose> poses = read_poses(folder / "poses.txt", names.size());
  Dataset dataset = dataset_of(folder);
  CameraFile millimetres;
  millimetres.depth_factor = 1000;
  calibrate(
      dataset, options, millimetres, [] { return std::nullopt; }, "");

  const FrameTimes times = frame_times(folder / "times.txt", names, options.fps, kHololensRate);
  dataset.times_source = times.source;
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < names.size(); ++i) {
    FrameFiles frame{times.times[i], existing_file(color, names[i], times.times[i], fingerprint), {}, 0};
    if (!depths.empty())
      frame.depth = existing_file(folder / "depth", depths[i], times.times[i], fingerprint);
    dataset.frames.push_back(std::move(frame));
    dataset.truth.add(times.times[i], poses[i]);
  }
  dataset.truth_source = "poses.txt";
  dataset.fingerprint = fingerprint.text();
  return dataset;
}

}  // namespace

DatasetReader hololens_reader() {
  return {"hololens", "color and depth folders with poses.txt", recognise_hololens, open_hololens};
}

}  // namespace framewise
