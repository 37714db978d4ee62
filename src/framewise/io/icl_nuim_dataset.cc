// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// ICL-NUIM: rendered rooms. Its cameras have fy = -480: their y points up, which makes them left-handed.
// Pixels and depth stay as they are; here y points down, and poses are mirrored into that world and camera.
//   Handa et al., A benchmark for RGB-D visual odometry, 3D reconstruction and SLAM, ICRA 2014.
#include <fmt/format.h>

#include "framewise/io/axes.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_lists.h"
#include "framewise/io/file_names.h"
#include "framewise/io/tum_layout.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kRenderRate = 30;

fs::path truth_file(const fs::path& folder) {
  for (const std::string& name : files_in(folder, {".freiburg"})) return folder / name;
  return first_existing(folder, {"groundtruth.txt"});
}

std::string recognise_icl_nuim(const fs::path& folder) {
  if (association_file(folder).empty()) return "";
  const std::string name = lower_case(folder_name(folder));
  for (const char* part : {"living_room_traj", "office_room_traj", "_frei_png", "icl-nuim", "icl_nuim"})
    if (name.find(part) != std::string::npos) return "its name says " + std::string(part);
  const fs::path truth = truth_file(folder);
  return truth.extension() == ".freiburg" ? "it has " + truth.filename().string() : "";
}

// Its stamps are the frames' numbers.
bool counts_frames(const Dataset& dataset) {
  for (const FrameFiles& frame : dataset.frames)
    if (frame.time != static_cast<double>(static_cast<long>(frame.time))) return false;
  return true;
}

void number_to_seconds(Dataset& dataset, double rate) {
  for (FrameFiles& frame : dataset.frames) {
    frame.time /= rate;
    frame.depth_delay /= rate;
  }
  for (double& time : dataset.truth.times) time /= rate;
}

Dataset open_icl_nuim(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a data set of ICL-NUIM");
  Dataset dataset = dataset_of(folder);
  calibrate(
      dataset, options, {}, [] { return NamedCalibration(*known_calibration("icl-nuim"), "icl-nuim"); }, "");
  read_tum_frames(dataset, options.max_time_difference);
  read_tum_truth(dataset, truth_file(folder));
  if (counts_frames(dataset)) {
    const double rate = options.fps.value_or(kRenderRate);
    number_to_seconds(dataset, rate);
    dataset.times_source += fmt::format(" (numbers of frames, {} a second)", rate);
  }
  // A camera file that keeps the negative fy keeps the renderer's axes as well.
  if (!(dataset.calibration.camera.fy < 0))
    for (Pose& pose : dataset.truth.world_from_cam) pose = mirrored_in_y(pose);
  return dataset;
}

}  // namespace

DatasetReader icl_nuim_reader() {
  return {"icl-nuim", "associations.txt and a truth *.gt.freiburg", recognise_icl_nuim, open_icl_nuim};
}

}  // namespace framewise
