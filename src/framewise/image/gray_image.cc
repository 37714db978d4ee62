// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/gray_image.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace framewise {
namespace {

const char* kind_of(int depth) {
  if (depth == CV_8U || depth == CV_16U) return "unsigned";
  return depth == CV_32F || depth == CV_64F || depth == CV_16F ? "floating point" : "signed";
}

void check_pixels(const cv::Mat& image) {
  const int channels = image.channels();
  const bool is_known_depth = image.depth() == CV_8U || image.depth() == CV_16U;
  if (is_known_depth && (channels == 1 || channels == 3 || channels == 4)) return;
  throw std::invalid_argument("image: found " + std::to_string(channels) + " channel(s) of " +
                              std::to_string(8 * image.elemSize1()) + " bits, " + kind_of(image.depth()) +
                              ", expected 1, 3 or 4 of 8 or 16 bits, unsigned");
}

}  // namespace

cv::Mat gray_image(const cv::Mat& image) {
  if (image.empty()) return {};
  check_pixels(image);
  cv::Mat gray = image;
  if (image.channels() > 1)
    cv::cvtColor(image, gray, image.channels() == 3 ? cv::COLOR_BGR2GRAY : cv::COLOR_BGRA2GRAY);
  if (gray.depth() == CV_16U) gray.convertTo(gray, CV_8U, 255.0 / 65535.0);
  return gray;
}

}  // namespace framewise
