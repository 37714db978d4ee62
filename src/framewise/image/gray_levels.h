// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

// Float images to the levels that files and feature detectors want. Level 0 is what is unknown (NaN).

// unit: CV_32F in [0, 1] -> CV_16U, value x 65535 to the nearest level.
cv::Mat to_16_bit(const cv::Mat& unit);
// -> CV_8U, value x 255 to the nearest level.
cv::Mat to_8_bit(const cv::Mat& unit);

struct DepthRange {
  double near = 0;  // what is nearer gets the darkest level (m)
  double far = 0;   // what is farther gets the brightest (m); 0: the image's farthest depth

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Depth to [1/255, 1], linear from near to far, so that the nearest is told from the unknown in 8 bits too.
// depth: CV_32F, unknown where NaN, infinite or not above 0; the answer CV_32F, NaN there.
cv::Mat depth_to_unit(const cv::Mat& depth, const DepthRange& range);

struct ClaheOptions {
  double clip_limit = 4;  // of a tile's histogram, as multiples of an even one
  int tiles = 8;          // across and down

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Contrast-limited adaptive histogram equalisation (OpenCV's, on 16-bit levels), to CV_8U. unit: CV_32F in
// [0, 1].
//   Zuiderveld, Contrast limited adaptive histogram equalization, Graphics Gems IV, 1994.
cv::Mat equalise_to_8_bit(const cv::Mat& unit, const ClaheOptions& options);

}  // namespace framewise
