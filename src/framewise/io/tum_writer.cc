// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/tum_writer.h"

#include <fmt/format.h>

#include <stdexcept>

#include "framewise/io/imu_writer.h"
#include "framewise/io/recording_parts.h"

namespace framewise {

namespace fs = std::filesystem;

TumWriter::TumWriter(const fs::path& folder, const Camera& camera, double depth_factor)
    : TumWriter(folder, camera, DepthStorage{depth_factor, DepthType::kZ, std::nullopt}) {}

TumWriter::TumWriter(const fs::path& folder, const Camera& camera, const DepthStorage& storage)
    : RecordingWriter(folder, camera, storage, {"rgb.txt", "depth.txt", "groundtruth.txt"}) {
  make_folder(folder_ / "rgb");
  make_folder(folder_ / "depth");
  rgb_list_ = open_output(folder_ / "rgb.txt");
  depth_list_ = open_output(folder_ / "depth.txt");
  rgb_list_ << "# color images\n# timestamp filename\n";
  depth_list_ << "# depth maps\n# timestamp filename\n";
  write_whole(folder_ / "camera.yaml", camera_yaml(camera_, storage_));
}

void TumWriter::write_depth(const std::string& folder, const std::string& stamp, const cv::Mat& depth,
                            std::ofstream& list) {
  write_depth_png(folder_ / folder / (stamp + ".png"), raw_depth(depth));
  list << stamp << " " << folder << "/" << stamp << ".png\n" << std::flush;
}

void TumWriter::write_frame(const Frame& frame, const cv::Mat& true_depth) {
  const std::string stamp = fmt::format("{:.6f}", frame.time);
  write_photo_png(folder_ / "rgb" / (stamp + ".png"), frame.color);
  rgb_list_ << stamp << " rgb/" << stamp << ".png\n" << std::flush;
  write_depth("depth", stamp, frame.depth, depth_list_);
  if (!true_depth.empty()) {
    if (!true_depth_list_.is_open()) {
      make_folder(folder_ / "depth_true");
      true_depth_list_ = open_output(folder_ / "depth_true.txt");
      true_depth_list_ << "# depth maps without the sensor's faults\n# timestamp filename\n";
    }
    write_depth("depth_true", stamp, true_depth, true_depth_list_);
  }
  if (!rgb_list_ || !depth_list_ || (true_depth_list_.is_open() && !true_depth_list_))
    throw std::runtime_error(fmt::format("{}: the lists cannot be written", folder_.string()));
}

void TumWriter::finish(const Trajectory& truth) {
  write_whole(folder_ / "groundtruth.txt", tum_truth(truth));
  close_output(rgb_list_, folder_ / "rgb.txt");
  close_output(depth_list_, folder_ / "depth.txt");
  if (true_depth_list_.is_open()) close_output(true_depth_list_, folder_ / "depth_true.txt");
}

void TumWriter::write_imu(std::span<const ImuReading> readings, std::span<const ImuReading> truth, double) {
  framewise::write_imu(folder_ / "imu.csv", readings);
  framewise::write_imu(folder_ / "imu_true.csv", truth);
}

}  // namespace framewise
