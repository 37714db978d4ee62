// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "framewise/simulation/color_pass.h"

namespace framewise {

// Draws pixels that a border between two surfaces passes through as mixtures of what its two sides show.
// Where the border lies between the centres of two neighbours, three rays tell to an eighth of a pixel.
//   image  what the centres see, of as many pixels; CV_8UC3 or CV_32FC3
cv::Mat with_smooth_edges(const View& view, const Centres& centres, const cv::Mat& image);

}  // namespace framewise
