// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

// What a camera saw at one time. Images that exist are of one size and registered: a pixel is the same ray in
// all.
struct Frame {
  double time = 0;         // s
  cv::Mat gray;            // CV_8U
  cv::Mat color;           // CV_8UC3, blue green red; may be empty
  cv::Mat depth;           // CV_32F, z in metres, NaN where unknown; may be empty
  double depth_delay = 0;  // when the depth image was taken, after `time` (s)
};

}  // namespace framewise
