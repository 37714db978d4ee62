// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "framewise/simulation/color.h"

namespace framewise {

// An image as a texture: repeated over the plane, and averaged over the footprint of a pixel by halved copies
// of itself.
//   Williams, Pyramidal parametrics, SIGGRAPH 1983.
class ImageTexture {
 public:
  // CV_8UC3, blue green red, sRGB. Throws std::invalid_argument for another or an empty one.
  explicit ImageTexture(const cv::Mat& image);

  // At (u, v), each 0 to 1 over the image from its lower left corner, averaged over a footprint in units of
  // its width. Linear light.
  Color at(float u, float v, float footprint) const;

 private:
  std::vector<cv::Mat> levels_;  // CV_32FC3, red green blue, linear, each half the size of the one before
};

}  // namespace framewise
