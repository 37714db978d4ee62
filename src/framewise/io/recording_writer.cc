// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/recording_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "framewise/image/depth.h"
#include "framewise/io/euroc_writer.h"
#include "framewise/io/kitti_depth_writer.h"
#include "framewise/io/recording_parts.h"
#include "framewise/io/tum_writer.h"

namespace framewise {
namespace {

cv::Mat range_per_z(const Camera& camera) {
  cv::Mat factor(camera.height, camera.width, CV_32F, cv::Scalar(kUnknownDepth));
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u)
      if (const auto ray = camera.bearing({u, v}); ray && ray->z() > 0)
        factor.at<float>(v, u) = static_cast<float>(1 / ray->z());
  return factor;
}

void check_image(const char* name, const cv::Mat& image, int type, const char* kind, const Camera& camera) {
  if (image.type() == type && image.cols == camera.width && image.rows == camera.height) return;
  throw std::invalid_argument(fmt::format("frame: {} is {} x {} of type {}, expected {} x {} {}", name,
                                          image.cols, image.rows, image.type(), camera.width, camera.height,
                                          kind));
}

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& folder, const Camera& camera,
                                 const DepthStorage& storage, const std::vector<std::string>& files)
    : folder_(folder), camera_(camera), storage_(storage) {
  camera_.check();
  if (!(storage.factor > 0))
    throw std::invalid_argument(
        fmt::format("depth_factor is {}, expected a positive number", storage.factor));
  if (storage.type == DepthType::kRange) range_per_z_ = range_per_z(camera_);
  for (const std::string& file : files)
    if (std::filesystem::exists(folder_ / file))
      throw std::invalid_argument(
          fmt::format("{} exists, expected a folder without a recording", (folder_ / file).string()));
}

void RecordingWriter::add(const Frame& frame, const cv::Mat& true_depth) {
  check_image("color", frame.color, CV_8UC3, "8-bit colour", camera_);
  check_image("depth", frame.depth, CV_32F, "float metres", camera_);
  if (!true_depth.empty()) check_image("true_depth", true_depth, CV_32F, "float metres", camera_);
  if (!(frame.time >= 0 && frame.time >= last_time_ + 1e-6 - 1e-9))
    throw std::invalid_argument(
        fmt::format("frame: time is {:.9f} s, expected one after {:.6f} s", frame.time, last_time_));
  if (frames_ > 0 && has_true_depth_ == true_depth.empty())
    throw std::invalid_argument("frame: true depth comes with some frames, expected with all or none");
  has_true_depth_ = !true_depth.empty();
  last_time_ = frame.time;
  ++frames_;
  write_frame(frame, true_depth);
}

void RecordingWriter::write_text(const std::string& name, const std::string& text) {
  write_whole(folder_ / name, text);
}

cv::Mat RecordingWriter::raw_depth(const cv::Mat& depth) const {
  return depth_to_raw(range_per_z_.empty() ? depth : cv::Mat(depth.mul(range_per_z_)), storage_.factor);
}

const std::vector<std::string>& recording_layouts() {
  static const std::vector<std::string> layouts{"tum", "euroc", "kitti-depth"};
  return layouts;
}

std::unique_ptr<RecordingWriter> recording_writer(const std::string& layout,
                                                  const std::filesystem::path& folder, const Camera& camera,
                                                  const DepthStorage& storage, double rate_hz) {
  if (layout == "tum") return std::make_unique<TumWriter>(folder, camera, storage);
  if (layout == "euroc") return std::make_unique<EurocWriter>(folder, camera, storage, rate_hz);
  if (layout == "kitti-depth") return std::make_unique<KittiDepthWriter>(folder, camera, storage);
  throw std::invalid_argument(
      fmt::format("layout is '{}', expected one of: {}", layout, fmt::join(recording_layouts(), ", ")));
}

}  // namespace framewise
