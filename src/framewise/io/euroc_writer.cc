// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/euroc_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "framewise/io/imu_writer.h"
#include "framewise/io/recording_parts.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBodyIsSensor =
    "T_BS:\n  cols: 4\n  rows: 4\n"
    "  data: [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]\n";

std::string sensor_yaml(const std::string& type) {
  return fmt::format("sensor_type: {}\n# body_from_sensor\n{}", type, kBodyIsSensor);
}

std::string camera_sensor_yaml(const Camera& camera, double rate_hz) {
  const auto& d = camera.distortion;
  return sensor_yaml("camera") + fmt::format(
                                     "rate_hz: {}\nresolution: [{}, {}]\ncamera_model: pinhole\n"
                                     "intrinsics: [{}, {}, {}, {}]  # fu, fv, cu, cv\n"
                                     "distortion_model: radial-tangential\n"
                                     "distortion_coefficients: [{}, {}, {}, {}]\n",
                                     rate_hz, camera.width, camera.height, camera.fx, camera.fy, camera.cx,
                                     camera.cy, d[0], d[1], d[2], d[3]);
}

std::string truth_csv(const Trajectory& truth) {
  std::string text =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n";
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d& t = truth.world_from_cam[i].t;
    const Eigen::Quaterniond q = truth.world_from_cam[i].quaternion();
    text += fmt::format("{},{},{},{},{},{},{},{}\n", std::llround(truth.times[i] * 1e9), t.x(), t.y(), t.z(),
                        q.w(), q.x(), q.y(), q.z());
  }
  return text;
}

void write_sensor(const fs::path& folder, const std::string& yaml) {
  make_folder(folder);
  write_whole(folder / "sensor.yaml", yaml);
}

}  // namespace

EurocWriter::EurocWriter(const fs::path& folder, const Camera& camera, const DepthStorage& storage,
                         double rate_hz)
    : RecordingWriter(folder, camera, storage, {"mav0"}), rate_hz_(rate_hz) {
  if (camera.model != CameraModel::kPinhole || camera.distortion[4] != 0)
    throw std::invalid_argument("layout is 'euroc', expected a pinhole with k1, k2, p1, p2 and k3 = 0");
  begin(gray_, "cam0");
  begin(depth_, "depth0");
}

void EurocWriter::begin(ImageList& list, const std::string& name) const {
  list.folder = folder_ / "mav0" / name;
  make_folder(list.folder / "data");
  write_sensor(list.folder, camera_sensor_yaml(camera_, rate_hz_));
  if (name != "cam0") write_whole(list.folder / "camera.yaml", camera_yaml(camera_, storage_));
  list.lines = open_output(list.folder / "data.csv");
  list.lines << "#timestamp [ns],filename\n";
}

void EurocWriter::write_frame(const Frame& frame, const cv::Mat& true_depth) {
  const auto stamp = std::llround(frame.time * 1e9);
  const std::string name = fmt::format("{}.png", stamp);
  write_photo_png(gray_.folder / "data" / name, frame.gray);
  write_depth_png(depth_.folder / "data" / name, raw_depth(frame.depth));
  if (!true_depth.empty()) {
    if (!true_depth_.lines.is_open()) begin(true_depth_, "depth0_true");
    write_depth_png(true_depth_.folder / "data" / name, raw_depth(true_depth));
  }
  for (ImageList* list : {&gray_, &depth_, &true_depth_}) {
    if (!list->lines.is_open()) continue;
    list->lines << stamp << "," << name << "\n" << std::flush;
    if (!list->lines)
      throw std::runtime_error(fmt::format("{}: the list cannot be written", list->folder.string()));
  }
}

void EurocWriter::finish(const Trajectory& truth) {
  const fs::path sensor = folder_ / "mav0" / "mocap0";
  write_sensor(sensor, sensor_yaml("mocap"));
  write_whole(sensor / "data.csv", truth_csv(truth));
  for (ImageList* list : {&gray_, &depth_, &true_depth_})
    if (list->lines.is_open()) close_output(list->lines, list->folder / "data.csv");
}

void EurocWriter::write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth,
                            double rate_hz) {
  for (const auto& [name, values] : {std::pair("imu0", readings), {"imu0_true", truth}}) {
    const fs::path sensor = folder_ / "mav0" / name;
    write_sensor(sensor, sensor_yaml("imu") + fmt::format("rate_hz: {}\n", rate_hz));
    framewise::write_imu(sensor / "data.csv", values);
  }
}

}  // namespace framewise
