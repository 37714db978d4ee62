// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/depth.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/image/image_check.h"

namespace framewise {

cv::Mat depth_from_raw(const cv::Mat& raw, double factor, double max_depth) {
  cv::Mat depth(raw.size(), CV_32F);
  const float metres = static_cast<float>(1.0 / factor);
  const float farthest = static_cast<float>(max_depth);
  if (raw.type() == CV_32F) {
    for (int v = 0; v < raw.rows; ++v)
      for (int u = 0; u < raw.cols; ++u) {
        const float z = raw.at<float>(v, u);
        depth.at<float>(v, u) = is_known_depth(z) && z <= farthest ? z : kUnknownDepth;
      }
    return depth;
  }
  check_image("raw", raw, CV_16U);
  for (int v = 0; v < raw.rows; ++v) {
    const auto* in = raw.ptr<std::uint16_t>(v);
    auto* out = depth.ptr<float>(v);
    for (int u = 0; u < raw.cols; ++u) {
      const float z = metres * static_cast<float>(in[u]);
      out[u] = in[u] == 0 || z > farthest ? kUnknownDepth : z;
    }
  }
  return depth;
}

cv::Mat depth_to_raw(const cv::Mat& depth, double factor) {
  check_image("depth", depth, CV_32F);
  cv::Mat raw(depth.size(), CV_16U);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double value = std::round(depth.at<float>(v, u) * factor);
      raw.at<std::uint16_t>(v, u) = value > 0 && value <= 65535 ? static_cast<std::uint16_t>(value) : 0;
    }
  return raw;
}

void DepthLookupOptions::check() const {
  const auto require = [](bool holds, const char* name, double found, const char* expected) {
    if (!holds)
      throw std::invalid_argument(std::string(name) + ": found " + std::to_string(found) + ", expected " +
                                  expected);
  };
  require(border_px >= 1, "border_px", border_px, "at least 1");
  require(max_edge > 0, "max_edge", max_edge, "more than 0");
  require(min_depth >= 0, "min_depth", min_depth, "at least 0");
  require(max_depth > min_depth, "max_depth", max_depth, "more than min_depth");
}

std::optional<double> depth_at(const cv::Mat& depth, const Eigen::Vector2d& pixel,
                               const DepthLookupOptions& options) {
  const int u = static_cast<int>(std::lround(pixel.x())), v = static_cast<int>(std::lround(pixel.y()));
  const int border = options.border_px;
  if (u < border || v < border || u >= depth.cols - border || v >= depth.rows - border) return std::nullopt;

  const float centre = depth.at<float>(v, u);
  if (!(centre >= options.min_depth && centre <= options.max_depth)) return std::nullopt;
  const float max_difference = static_cast<float>(options.max_edge) * centre;
  int known = 0;
  double sum = 0;
  for (int dv = -1; dv <= 1; ++dv) {
    const float* row = depth.ptr<float>(v + dv) + u;
    for (int du = -1; du <= 1; ++du) {
      const float z = row[du];
      if (std::isnan(z)) continue;
      if (std::abs(z - centre) > max_difference) return std::nullopt;
      ++known;
      sum += z;
    }
  }
  if (known < 5) return std::nullopt;
  return sum / known;
}

}  // namespace framewise
