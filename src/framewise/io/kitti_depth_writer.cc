// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/kitti_depth_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "framewise/io/imu_writer.h"
#include "framewise/io/recording_parts.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

const fs::path kMeasured = fs::path("proj_depth") / "velodyne_raw" / "image_02";
const fs::path kTrue = fs::path("proj_depth") / "groundtruth" / "image_02";

std::string calib_txt(const Camera& camera) {
  std::string text;
  for (int k = 0; k < 4; ++k)
    text += fmt::format("P{}: {} 0 {} 0 0 {} {} 0 0 0 1 0\n", k, camera.fx, camera.cx, camera.fy, camera.cy);
  return text;
}

std::string times_txt(const std::vector<double>& times) {
  std::string text;
  for (const double time : times) text += fmt::format("{:.6f}\n", time);
  return text;
}

// The pose whose time is a frame's but for rounding.
const Pose& pose_of_frame(const Trajectory& truth, double time) {
  const auto after = std::lower_bound(truth.times.begin(), truth.times.end(), time - 1e-7);
  if (after == truth.times.end() || *after > time + 1e-7)
    throw std::invalid_argument(fmt::format("truth has no pose at {:.6f} s, expected one a frame", time));
  return truth.world_from_cam[static_cast<std::size_t>(after - truth.times.begin())];
}

std::string poses_txt(const Trajectory& truth, const std::vector<double>& times) {
  std::string text;
  for (const double time : times) {
    const Pose& pose = pose_of_frame(truth, time);
    for (int i = 0; i < 3; ++i)
      text += fmt::format("{} {} {} {}{}", pose.R(i, 0), pose.R(i, 1), pose.R(i, 2), pose.t(i),
                          i < 2 ? " " : "\n");
  }
  return text;
}

}  // namespace

KittiDepthWriter::KittiDepthWriter(const fs::path& folder, const Camera& camera, const DepthStorage& storage)
    : RecordingWriter(folder, camera, storage, {"image_2", "proj_depth", "calib.txt"}) {
  if (camera.model != CameraModel::kPinhole || camera.is_distorted())
    throw std::invalid_argument("layout is 'kitti-depth', expected a pinhole without distortion");
  if (storage.type != DepthType::kZ || storage.factor != 256)
    throw std::invalid_argument("layout is 'kitti-depth', expected depth type z and 256 units in a metre");
  make_folder(folder_ / "image_2");
  make_folder(folder_ / kMeasured);
  write_whole(folder_ / "calib.txt", calib_txt(camera_));
}

void KittiDepthWriter::write_frame(const Frame& frame, const cv::Mat& true_depth) {
  const std::string name = fmt::format("{:010}.png", times_.size());
  write_photo_png(folder_ / "image_2" / name, frame.color);
  write_depth_png(folder_ / kMeasured / name, raw_depth(frame.depth));
  if (!true_depth.empty()) {
    if (!has_true_depth_) make_folder(folder_ / kTrue);
    has_true_depth_ = true;
    write_depth_png(folder_ / kTrue / name, raw_depth(true_depth));
  }
  times_.push_back(frame.time);
}

std::vector<fs::path> KittiDepthWriter::depth_folders() const {
  std::vector<fs::path> folders{folder_ / kMeasured};
  if (has_true_depth_) folders.push_back(folder_ / kTrue);
  return folders;
}

void KittiDepthWriter::finish(const Trajectory& truth) {
  write_whole(folder_ / "times.txt", times_txt(times_));
  write_whole(folder_ / "poses.txt", poses_txt(truth, times_));
  write_whole(folder_ / "groundtruth.txt", tum_truth(truth));
  for (const fs::path& folder : depth_folders()) {
    write_whole(folder / "camera.yaml", camera_yaml(camera_, storage_));
    write_whole(folder / "times.txt", times_txt(times_));
  }
}

void KittiDepthWriter::write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth,
                                 double) {
  framewise::write_imu(folder_ / "imu.csv", readings);
  framewise::write_imu(folder_ / "imu_true.csv", truth);
}

}  // namespace framewise
