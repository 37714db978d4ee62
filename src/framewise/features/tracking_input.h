// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

namespace framewise {

// What tracking asks of its arguments; throws std::invalid_argument that names what does not keep to it.
inline void check_tracking_option(bool good, const char* option, double found, const char* expected) {
  if (!good)
    throw std::invalid_argument(std::string(option) + ": found " + std::to_string(found) + ", expected " +
                                expected);
}

inline void check_tracking_image(const cv::Mat& gray) {
  if (!gray.empty() && gray.dims == 2 && gray.type() == CV_8U) return;
  const std::string found = gray.empty() ? "no pixels" : cv::typeToString(gray.type());
  throw std::invalid_argument("gray: found " + found + ", expected an image of CV_8UC1");
}

}  // namespace framewise
