// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/recording_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace framewise {
namespace {

namespace fs = std::filesystem;

void write_png(const fs::path& file, const cv::Mat& image, int strategy) {
  if (!cv::imwrite(file.string(), image,
                   {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY, strategy}))
    throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace

std::ofstream open_output(const fs::path& file) {
  std::ofstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
  return stream;
}

void close_output(std::ofstream& stream, const fs::path& file) {
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("{}: could not be written to its end", file.string()));
}

void write_whole(const fs::path& file, const std::string& text) {
  std::ofstream stream = open_output(file);
  stream << text;
  close_output(stream, file);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("{}: {}", folder.string(), error.message()));
}

// The strategies are those that are quick both to write and to read: on 640 x 480 colour Huffman codes alone
// take two thirds of the default's time and are smaller; depth has runs that the default finds.
void write_photo_png(const fs::path& file, const cv::Mat& image) {
  write_png(file, image, cv::IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY);
}

void write_depth_png(const fs::path& file, const cv::Mat& depth) {
  write_png(file, depth, cv::IMWRITE_PNG_STRATEGY_DEFAULT);
}

std::string camera_yaml(const Camera& camera, const DepthStorage& storage) {
  std::string text = fmt::format("# depth is registered to this camera\nmodel: {}\nwidth: {}\nheight: {}\n",
                                 name_of(camera.model), camera.width, camera.height);
  if (camera.model == CameraModel::kEquirectangular) {
    text += fmt::format("theta_range_deg: [{}, {}]\n", camera.theta_range[0] * 180 / M_PI,
                        camera.theta_range[1] * 180 / M_PI);
  } else {
    text += fmt::format("fx: {}\nfy: {}\ncx: {}\ncy: {}\n", camera.fx, camera.fy, camera.cx, camera.cy);
    const auto& d = camera.distortion;
    text += camera.model == CameraModel::kFisheye
                ? fmt::format("distortion: [{}, {}, {}, {}]\n", d[0], d[1], d[2], d[3])
                : fmt::format("distortion: [{}, {}, {}, {}, {}]\n", d[0], d[1], d[2], d[3], d[4]);
  }
  text += fmt::format("depth_factor: {}\n", storage.factor);
  if (storage.type == DepthType::kRange) text += fmt::format("depth_type: {}\n", name_of(storage.type));
  if (storage.max) text += fmt::format("depth_max: {}\n", *storage.max);
  return text;
}

std::string tum_truth(const Trajectory& truth) {
  std::string text =
      "# ground truth trajectory\n# world_from_cam, optical axes (x right, y down, z forward)\n";
  text += "# timestamp tx ty tz qx qy qz qw\n";
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d& t = truth.world_from_cam[i].t;
    const Eigen::Quaterniond q = truth.world_from_cam[i].quaternion();
    text += fmt::format("{:.6f} {} {} {} {} {} {} {}\n", truth.times[i], t.x(), t.y(), t.z(), q.x(), q.y(),
                        q.z(), q.w());
  }
  return text;
}

}  // namespace framewise
