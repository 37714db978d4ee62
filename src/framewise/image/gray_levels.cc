// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/gray_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"

namespace framewise {
namespace {

template <typename Level>
cv::Mat to_levels(const cv::Mat& unit) {
  check_image("unit", unit, CV_32F);
  constexpr float kMost = std::numeric_limits<Level>::max();
  cv::Mat levels(unit.size(), cv::traits::Type<Level>::value);
  for (int v = 0; v < unit.rows; ++v) {
    const float* in = unit.ptr<float>(v);
    Level* out = levels.ptr<Level>(v);
    for (int u = 0; u < unit.cols; ++u) {
      const float known = in[u] > 0 ? std::min(in[u], 1.0f) : 0.0f;  // NaN is not above 0
      out[u] = static_cast<Level>(known * kMost + 0.5f);
    }
  }
  return levels;
}

float farthest(const cv::Mat& depth) {
  float most = 0;
  for (int v = 0; v < depth.rows; ++v)
    for (const float* z = depth.ptr<float>(v); z != depth.ptr<float>(v) + depth.cols; ++z)
      if (is_known_depth(*z)) most = std::max(most, *z);
  return most;
}

}  // namespace

cv::Mat to_16_bit(const cv::Mat& unit) { return to_levels<std::uint16_t>(unit); }
cv::Mat to_8_bit(const cv::Mat& unit) { return to_levels<std::uint8_t>(unit); }

void DepthRange::check() const {
  if (!(near >= 0) || !std::isfinite(near))
    throw std::invalid_argument("near: found " + std::to_string(near) + ", expected at least 0");
  if (far != 0 && (!(far > near) || !std::isfinite(far)))
    throw std::invalid_argument("far: found " + std::to_string(far) + ", expected more than near, or 0");
}

cv::Mat depth_to_unit(const cv::Mat& depth, const DepthRange& range) {
  check_image("depth", depth, CV_32F);
  range.check();
  const float near = static_cast<float>(range.near);
  const float far = range.far > 0 ? static_cast<float>(range.far) : farthest(depth);
  const float per_metre = far > near ? (254.0f / 255) / (far - near) : 0;
  cv::Mat unit(depth.size(), CV_32F);
  for (int v = 0; v < depth.rows; ++v) {
    const float* in = depth.ptr<float>(v);
    float* out = unit.ptr<float>(v);
    for (int u = 0; u < depth.cols; ++u)
      out[u] = is_known_depth(in[u])
                   ? 1.0f / 255 + per_metre * (std::clamp(in[u], near, std::max(near, far)) - near)
                   : kUnknownDepth;
  }
  return unit;
}

void ClaheOptions::check() const {
  if (!(clip_limit > 0) || !std::isfinite(clip_limit))
    throw std::invalid_argument("clip_limit: found " + std::to_string(clip_limit) + ", expected more than 0");
  if (tiles < 1 || tiles > 256)
    throw std::invalid_argument("tiles: found " + std::to_string(tiles) + ", expected 1 to 256");
}

cv::Mat equalise_to_8_bit(const cv::Mat& unit, const ClaheOptions& options) {
  options.check();
  const cv::Mat levels = to_16_bit(unit);
  const int across = std::min(options.tiles, levels.cols), down = std::min(options.tiles, levels.rows);
  cv::Mat equalised, gray;
  cv::createCLAHE(options.clip_limit, cv::Size(across, down))->apply(levels, equalised);
  equalised.convertTo(gray, CV_8U, 255.0 / 65535);
  gray.setTo(0, levels == 0);
  return gray;
}

}  // namespace framewise
