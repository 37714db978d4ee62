// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/tum_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "framewise/image/depth.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

std::ofstream open_output(const fs::path& file) {
  std::ofstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
  return stream;
}

void close(std::ofstream& stream, const fs::path& file) {
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("{}: could not be written to its end", file.string()));
}

void write_whole(const fs::path& file, const std::string& text) {
  std::ofstream stream = open_output(file);
  stream << text;
  close(stream, file);
}

// The strategies are those that are quick both to write and to read: on 640 x 480 colour Huffman codes alone
// take two thirds of the default's time and are smaller; depth has runs that the default finds.
void write_png(const fs::path& file, const cv::Mat& image, int strategy) {
  if (!cv::imwrite(file.string(), image,
                   {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY, strategy}))
    throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

std::string camera_yaml(const Camera& camera, const TumWriter::DepthStorage& storage) {
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

cv::Mat range_per_z(const Camera& camera) {
  cv::Mat factor(camera.height, camera.width, CV_32F, cv::Scalar(kUnknownDepth));
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u)
      if (const auto ray = camera.bearing({u, v}); ray && ray->z() > 0)
        factor.at<float>(v, u) = static_cast<float>(1 / ray->z());
  return factor;
}

std::string truth_lines(const Trajectory& truth) {
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

void check_image(const char* name, const cv::Mat& image, int type, const char* kind, const Camera& camera) {
  if (image.type() == type && image.cols == camera.width && image.rows == camera.height) return;
  throw std::invalid_argument(fmt::format("frame: {} is {} x {} of type {}, expected {} x {} {}", name,
                                          image.cols, image.rows, image.type(), camera.width, camera.height,
                                          kind));
}

}  // namespace

TumWriter::TumWriter(const fs::path& folder, const Camera& camera, double depth_factor)
    : TumWriter(folder, camera, DepthStorage{depth_factor, DepthType::kZ, std::nullopt}) {}

TumWriter::TumWriter(const fs::path& folder, const Camera& camera, const DepthStorage& storage)
    : folder_(folder), camera_(camera), storage_(storage) {
  camera_.check();
  if (!(storage.factor > 0))
    throw std::invalid_argument(
        fmt::format("depth_factor is {}, expected a positive number", storage.factor));
  if (storage.type == DepthType::kRange) range_per_z_ = range_per_z(camera_);
  for (const char* list : {"rgb.txt", "depth.txt", "groundtruth.txt"})
    if (fs::exists(folder_ / list))
      throw std::invalid_argument(
          fmt::format("{} exists, expected a folder without a recording", (folder_ / list).string()));
  std::error_code error;
  for (const char* name : {"rgb", "depth"}) {
    fs::create_directories(folder_ / name, error);
    if (error) throw std::runtime_error(fmt::format("{}: {}", (folder_ / name).string(), error.message()));
  }
  rgb_list_ = open_output(folder_ / "rgb.txt");
  depth_list_ = open_output(folder_ / "depth.txt");
  rgb_list_ << "# color images\n# timestamp filename\n";
  depth_list_ << "# depth maps\n# timestamp filename\n";
  write_whole(folder_ / "camera.yaml", camera_yaml(camera_, storage_));
}

void TumWriter::write_depth(const std::string& folder, const std::string& stamp, const cv::Mat& depth,
                            std::ofstream& list) {
  const cv::Mat stored = range_per_z_.empty() ? depth : cv::Mat(depth.mul(range_per_z_));
  write_png(folder_ / folder / (stamp + ".png"), depth_to_raw(stored, storage_.factor),
            cv::IMWRITE_PNG_STRATEGY_DEFAULT);
  list << stamp << " " << folder << "/" << stamp << ".png\n" << std::flush;
}

void TumWriter::add(const Frame& frame, const cv::Mat& true_depth) {
  check_image("color", frame.color, CV_8UC3, "8-bit colour", camera_);
  check_image("depth", frame.depth, CV_32F, "float metres", camera_);
  if (!(frame.time >= 0 && frame.time >= last_time_ + 1e-6 - 1e-9))
    throw std::invalid_argument(
        fmt::format("frame: time is {:.9f} s, expected one after {:.6f} s", frame.time, last_time_));
  last_time_ = frame.time;
  const std::string stamp = fmt::format("{:.6f}", frame.time);
  write_png(folder_ / "rgb" / (stamp + ".png"), frame.color, cv::IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY);
  rgb_list_ << stamp << " rgb/" << stamp << ".png\n" << std::flush;
  write_depth("depth", stamp, frame.depth, depth_list_);
  if (!true_depth.empty()) {
    check_image("true_depth", true_depth, CV_32F, "float metres", camera_);
    if (!true_depth_list_.is_open()) {
      fs::create_directories(folder_ / "depth_true");
      true_depth_list_ = open_output(folder_ / "depth_true.txt");
      true_depth_list_ << "# depth maps without the sensor's faults\n# timestamp filename\n";
    }
    write_depth("depth_true", stamp, true_depth, true_depth_list_);
  }
  if (!rgb_list_ || !depth_list_ || (true_depth_list_.is_open() && !true_depth_list_))
    throw std::runtime_error(fmt::format("{}: the lists cannot be written", folder_.string()));
}

void TumWriter::finish(const Trajectory& truth) {
  write_whole(folder_ / "groundtruth.txt", truth_lines(truth));
  close(rgb_list_, folder_ / "rgb.txt");
  close(depth_list_, folder_ / "depth.txt");
  if (true_depth_list_.is_open()) close(true_depth_list_, folder_ / "depth_true.txt");
}

void TumWriter::write_text(const std::string& name, const std::string& text) {
  write_whole(folder_ / name, text);
}

}  // namespace framewise
