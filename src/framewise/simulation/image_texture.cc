// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/image_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace framewise {
namespace {

cv::Mat linear_light(const cv::Mat& image) {
  std::array<float, 256> table;
  for (std::uint32_t i = 0; i < 256; ++i) table[i] = srgb(i).b;
  cv::Mat light(image.size(), CV_32FC3);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec3b& byte = image.at<cv::Vec3b>(y, x);
      light.at<cv::Vec3f>(y, x) = {table[byte[2]], table[byte[1]], table[byte[0]]};
    }
  return light;
}

// Between the four nearest pixels, the image repeated.
Color bilinear(const cv::Mat& level, float u, float v) {
  const float x = u * static_cast<float>(level.cols) - 0.5f,
              y = (1 - v) * static_cast<float>(level.rows) - 0.5f;
  const float left = std::floor(x), above = std::floor(y), s = x - left, t = y - above;
  const auto wrapped = [](float at, int size) {
    const int i = static_cast<int>(at) % size;
    return i < 0 ? i + size : i;
  };
  const int x0 = wrapped(left, level.cols), x1 = (x0 + 1) % level.cols, y0 = wrapped(above, level.rows),
            y1 = (y0 + 1) % level.rows;
  const cv::Vec3f upper = level.at<cv::Vec3f>(y0, x0) * (1 - s) + level.at<cv::Vec3f>(y0, x1) * s;
  const cv::Vec3f lower = level.at<cv::Vec3f>(y1, x0) * (1 - s) + level.at<cv::Vec3f>(y1, x1) * s;
  const cv::Vec3f light = upper * (1 - t) + lower * t;
  return {light[0], light[1], light[2]};
}

}  // namespace

ImageTexture::ImageTexture(const cv::Mat& image) {
  if (image.empty() || image.type() != CV_8UC3)
    throw std::invalid_argument("texture is " + std::to_string(image.cols) + " x " +
                                std::to_string(image.rows) + " of type " + std::to_string(image.type()) +
                                ", expected an 8-bit colour image");
  levels_.push_back(linear_light(image));
  while (levels_.back().cols > 1 || levels_.back().rows > 1) {
    const cv::Size half(std::max(1, levels_.back().cols / 2), std::max(1, levels_.back().rows / 2));
    cv::Mat smaller;
    cv::resize(levels_.back(), smaller, half, 0, 0, cv::INTER_AREA);
    levels_.push_back(smaller);
  }
}

Color ImageTexture::at(float u, float v, float footprint) const {
  const float pixels = std::max(1.0f, footprint * static_cast<float>(levels_.front().cols));
  const float level = std::min(std::log2(pixels), static_cast<float>(levels_.size() - 1));
  const auto fine = static_cast<std::size_t>(level);
  u -= std::floor(u);
  v -= std::floor(v);
  const Color sharp = bilinear(levels_[fine], u, v);
  if (fine + 1 == levels_.size()) return sharp;
  return mix(sharp, bilinear(levels_[fine + 1], u, v), level - static_cast<float>(fine));
}

}  // namespace framewise
