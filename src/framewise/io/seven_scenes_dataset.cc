// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// 7-Scenes, and recordings in its layout: frame-000000.color.png (or jpg), .depth.png (mm), .pose.txt (4x4,
// world_from_depth_camera).
//   Shotton et al., Scene coordinate regression forests for camera relocalization in RGB-D images, CVPR 2013.
#include <fmt/format.h>

#include <cmath>

#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/frame_times.h"
#include "framewise/io/input_error.h"
#include "framewise/io/pose_rows.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr double kKinectRate = 30;    // a Kinect's; the recordings have no stamps
constexpr double kUnknown = 65.5345;  // raw 65535 is unknown: farther than this is

bool is_color_image(const std::string& name) { return stem_of(name).ends_with(".color"); }

std::vector<std::string> color_images(const fs::path& folder) {
  std::vector<std::string> names = files_in(folder, image_extensions());
  std::erase_if(names, [](const std::string& name) { return !is_color_image(name); });
  return names;
}

std::string recognise_seven_scenes(const fs::path& folder) {
  for (const char* name : {"frame-000000.color.png", "frame-000000.color.jpg"})
    if (fs::exists(folder / name)) return std::string("it has ") + name;
  const auto names = color_images(folder);
  return names.empty() ? "" : "it has " + names.front();
}

// camera-intrinsics.txt, which recordings of other sensors in this layout have: 3 x 3, depth registered.
std::optional<NamedCalibration> written_intrinsics(const fs::path& folder, const std::string& first_image) {
  const fs::path file = folder / "camera-intrinsics.txt";
  if (!fs::exists(file)) return std::nullopt;
  const NumberRows rows(file, "3 rows of 3 numbers");
  if (rows.size() != 3) throw InputError(file, 0, "rows", std::to_string(rows.size()), "3");
  Eigen::Matrix3d K;
  for (int i = 0; i < 3; ++i) {
    const NumberRow& row = rows[static_cast<std::size_t>(i)];
    rows.expect_columns(row, row.fields.size() == 3, "3");
    for (int j = 0; j < 3; ++j) K(i, j) = rows.number(row, static_cast<std::size_t>(j), "intrinsics");
  }
  const auto [width, height] = image_size(folder / first_image);
  CameraFile calibration;
  calibration.camera = {CameraModel::kPinhole, width, height, K(0, 0), K(1, 1), K(0, 2), K(1, 2), {}, {}};
  calibration.camera.check();
  calibration.depth_factor = 1000;
  return NamedCalibration(calibration, file.filename().string());
}

bool is_the_benchmarks(const Camera& camera) {
  const Camera published = known_calibration("7-scenes-depth")->camera;
  return camera.fx == published.fx && camera.cx == published.cx && camera.cy == published.cy;
}

NamedCalibration calibration_of(const fs::path& folder, const std::string& first_image,
                                const DatasetOptions& options) {
  if (const auto written = written_intrinsics(folder, first_image))
    if (!is_the_benchmarks(written->first.camera)) return *written;
  const std::string name = options.register_depth ? "7-scenes" : "7-scenes-depth";
  return {*known_calibration(name), name};
}

// Empty where there is no file, and where tracking had failed (numbers that are not finite).
std::optional<Pose> read_pose_file(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  const NumberRows rows(file, "4 rows of 4 numbers");
  if (rows.size() != 4) throw InputError(file, 0, "rows", std::to_string(rows.size()), "4 (a 4x4 matrix)");
  Pose pose;
  for (int i = 0; i < 3; ++i) {
    const NumberRow& row = rows[static_cast<std::size_t>(i)];
    rows.expect_columns(row, row.fields.size() == 4, "4 (a row of a 4x4 matrix)");
    for (const std::string_view field : row.fields)
      if (lower_case(std::string(field)).find("inf") != std::string::npos || field == "nan")
        return std::nullopt;
    for (int j = 0; j < 4; ++j)
      (j < 3 ? pose.R(i, j) : pose.t(i)) = rows.number(row, static_cast<std::size_t>(j), "pose");
  }
  expect_rotation(file, 0, pose.R);
  return pose;
}

void add_frame(Dataset& dataset, const std::string& color, double time, const Pose& depth_cam_from_cam,
               Fingerprint& fingerprint) {
  const std::string stem(stem_of(color).substr(0, stem_of(color).size() - std::string(".color").size()));
  FrameFiles frame{time, existing_file(dataset.folder, color, time, fingerprint), {}, 0};
  if (fs::exists(dataset.folder / (stem + ".depth.png")))
    frame.depth = existing_file(dataset.folder, stem + ".depth.png", time, fingerprint);
  dataset.frames.push_back(std::move(frame));
  if (const auto world_from_depth_cam = read_pose_file(dataset.folder / (stem + ".pose.txt")))
    dataset.truth.add(time, *world_from_depth_cam * depth_cam_from_cam);
}

Dataset open_seven_scenes(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a data set in the layout of 7-Scenes");
  const auto names = color_images(folder);
  if (names.empty()) throw InputError(folder, 0, "", "no frame-000000.color.png", "images called so");
  Dataset dataset = dataset_of(folder);
  CameraFile millimetres;
  millimetres.depth_factor = 1000;
  calibrate(
      dataset, options, millimetres, [&] { return calibration_of(folder, names.front(), options); }, "");
  dataset.calibration.depth_max = std::min(dataset.calibration.depth_max, kUnknown);

  // Poses are the depth camera's; the calibration's camera may be another.
  const auto& depth_camera = dataset.calibration.depth_camera;
  const Pose depth_cam_from_cam = depth_camera ? depth_camera->cam_from_depth_cam.inverse() : Pose();
  const FrameTimes times = frame_times(folder / "times.txt", names, options.fps, kKinectRate);
  dataset.times_source = times.source;
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < names.size(); ++i)
    add_frame(dataset, names[i], times.times[i], depth_cam_from_cam, fingerprint);
  dataset.fingerprint = fingerprint.text();
  if (!dataset.truth.empty()) dataset.truth_source = "*.pose.txt";
  return dataset;
}

}  // namespace

DatasetReader seven_scenes_reader() {
  return {"7-scenes", "frame-000000.color.png", recognise_seven_scenes, open_seven_scenes};
}

}  // namespace framewise
