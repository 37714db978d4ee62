// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/image_check.h"

#include <stdexcept>
#include <string>

namespace framewise {
namespace {

std::string kind(int type) {
  static const char* const depths[] = {"unsigned 8-bit", "signed 8-bit", "unsigned 16-bit", "signed 16-bit",
                                       "signed 32-bit",  "float",        "double",          "half"};
  return std::to_string(CV_MAT_CN(type)) + " channel(s) of " + depths[CV_MAT_DEPTH(type)];
}

std::string size(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

}  // namespace

void check_image(const char* name, const cv::Mat& image, int type) {
  if (image.empty())
    throw std::invalid_argument(std::string(name) + ": found an empty image, expected one with pixels");
  if (image.dims != 2 || image.type() != type)
    throw std::invalid_argument(std::string(name) + ": found " + kind(image.type()) + ", expected " +
                                kind(type));
}

void check_image_size(const char* name, const cv::Mat& image, int width, int height) {
  if (image.cols != width || image.rows != height)
    throw std::invalid_argument(std::string(name) + ": found " + size(image.cols, image.rows) +
                                ", expected " + size(width, height));
}

}  // namespace framewise
