// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "framewise/simulation/sensor_view.h"

namespace framewise {

// What one ray through the centre of each pixel sees.
struct Centres {
  cv::Mat color;     // CV_8UC3
  cv::Mat triangle;  // CV_32S, -1 where there is none
  cv::Mat distance;  // CV_32F, z however far and in single precision, 0 where there is none
  cv::Mat radiance;  // CV_32FC3, empty where it is not asked for
  cv::Mat depth;     // CV_32F, empty where it is not asked for
};

Centres trace_centres(const View& view, bool with_radiance, bool with_depth);

}  // namespace framewise
