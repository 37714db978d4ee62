// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's ASL format: mav0 with one folder a sensor, each with data.csv and sensor.yaml; stamps in
// nanoseconds.
//   Burri et al., The EuRoC micro aerial vehicle datasets, IJRR 2016.
#include <fmt/format.h>

#include <fstream>

#include "framewise/io/dataset_parts.h"
#include "framewise/io/dataset_reader.h"
#include "framewise/io/file_names.h"
#include "framewise/io/gyroscope_file.h"
#include "framewise/io/input_error.h"
#include "framewise/io/trajectory_files.h"
#include "framewise/io/yaml_camera.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

// The folder that holds cam0: mav0 of a recording, or it itself.
fs::path sensors_of(const fs::path& folder) {
  for (const fs::path& candidate : {folder / "mav0", folder})
    if (fs::exists(candidate / "cam0" / "data.csv")) return candidate;
  return {};
}

std::string recognise_euroc(const fs::path& folder) {
  const fs::path sensors = sensors_of(folder);
  return sensors.empty() ? "" : sensors == folder ? "it has cam0/data.csv" : "it has mav0/cam0/data.csv";
}

// T_BS of a sensor: x_in_body = T_BS x_in_sensor. Without the file, or without T_BS in it, the sensor is the
// body.
Pose body_from_sensor(const fs::path& sensor) {
  const fs::path file = sensor / "sensor.yaml";
  if (!fs::exists(file)) return {};
  const YamlFields fields(file);
  return fields.has("T_BS") ? read_pose(fields, "T_BS") : Pose();
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

// "nanoseconds,file" of a line, or nothing for a comment.
std::optional<std::pair<double, std::string>> image_of(const fs::path& list, std::size_t number,
                                                       const std::string& line) {
  const std::string content = trimmed(line.substr(0, line.find('#')));
  if (content.empty()) return std::nullopt;
  const std::size_t comma = content.find(',');
  const std::string stamp = trimmed(content.substr(0, comma));
  const std::string file = comma == std::string::npos ? "" : trimmed(content.substr(comma + 1));
  if (stamp.empty() || file.empty() || stamp.find_first_not_of("0123456789") != std::string::npos)
    throw InputError(list, number, "", "'" + content.substr(0, 60) + "'", "nanoseconds,file");
  return std::pair(std::stod(stamp) / 1e9, file);
}

void read_euroc_images(Dataset& dataset, const fs::path& camera) {
  const fs::path list = camera / "data.csv";
  std::ifstream stream(list);
  if (!stream) throw InputError(list, 0, "", "no file", "EuRoC's list of images");
  Fingerprint fingerprint;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const auto image = image_of(list, number, line);
    if (!image) continue;
    const auto& [time, file] = *image;
    if (!dataset.frames.empty() && !(time > dataset.frames.back().time))
      throw InputError(list, number, "timestamp",
                       fmt::format("{} after {} s", time, dataset.frames.back().time),
                       "stamps that increase (is this one recording?)");
    dataset.frames.push_back(
        {time,
         existing_file(camera / "data", file, time, fingerprint, list, static_cast<int>(number)),
         {},
         0});
  }
  if (dataset.frames.empty()) throw InputError(list, 0, "", "an empty list", "lines of 'nanoseconds,file'");
  const double step = (dataset.frames.back().time - dataset.frames.front().time) /
                      static_cast<double>(std::max<std::size_t>(1, dataset.frames.size() - 1));
  if (dataset.frames.size() > 1 && step < 1e-5)
    throw InputError(list, 0, "timestamp", fmt::format("images {} s apart", step), "nanoseconds");
  dataset.fingerprint = fingerprint.text();
  dataset.times_source = "cam0/data.csv";
}

// Where the truth is: world_from_sensor, of a sensor with a T_BS of its own.
void read_euroc_truth(Dataset& dataset, const fs::path& sensors, const Pose& body_from_cam) {
  const fs::path sensor = first_existing(sensors, {"state_groundtruth_estimate0", "mocap0", "vicon0"});
  const fs::path file = sensor / "data.csv";
  if (sensor.empty() || !fs::exists(file)) return;
  const TrajectoryFile read = read_trajectory(file, TrajectoryFormat::kEuroc);
  dataset.truth = read.trajectory;
  dataset.truth_norm_error = read.norm_error;
  dataset.truth_source = sensor.filename().string();
  check_truth(file, dataset.truth, dataset.frames);
  const Pose sensor_from_cam = body_from_sensor(sensor).inverse() * body_from_cam;
  for (Pose& pose : dataset.truth.world_from_cam) pose = pose * sensor_from_cam;
}

void read_euroc_rates(Dataset& dataset, const fs::path& imu, const Pose& body_from_cam) {
  if (!fs::exists(imu / "data.csv")) return;
  dataset.gyroscope = read_gyroscope(imu / "data.csv");
  dataset.gyroscope.cam_from_gyro = body_from_cam.R.transpose() * body_from_sensor(imu).R;
}

Dataset open_euroc(const fs::path& folder, const DatasetOptions& options) {
  expect_folder(folder, "a recording in EuRoC's ASL format");
  const fs::path sensors = sensors_of(folder), camera = sensors / "cam0";
  if (sensors.empty())
    throw InputError(folder, 0, "", "no mav0/cam0/data.csv", "a recording in EuRoC's ASL format");
  Dataset dataset = dataset_of(folder);
  calibrate(
      dataset, options, {},
      [&]() -> std::optional<NamedCalibration> {
        if (!fs::exists(camera / "sensor.yaml")) return std::nullopt;
        return NamedCalibration(read_camera_file(camera / "sensor.yaml"), "cam0/sensor.yaml");
      },
      "cam0/sensor.yaml");
  read_euroc_images(dataset, camera);
  const Pose body_from_cam = body_from_sensor(camera);
  read_euroc_truth(dataset, sensors, body_from_cam);
  read_euroc_rates(dataset, sensors / "imu0", body_from_cam);
  return dataset;
}

}  // namespace

DatasetReader euroc_reader() { return {"euroc", "mav0/cam0/data.csv", recognise_euroc, open_euroc}; }

}  // namespace framewise
