// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

struct CornerOptions {
  int count = 1000;            // corners at most
  double quality = 0.01;       // a corner is at least this share as strong as the strongest of the image
  double min_distance_px = 7;  // between corners, so that they spread over the image
  int block = 3;               // side of the neighbourhood that makes a corner (pixels)

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// Corners worth tracking, the strongest first, at whole pixels: the smaller eigenvalue of the gradients'
// matrix is largest there (Shi, Tomasi, Good features to track, CVPR 1994). gray: CV_8U. `taken`: positions
// that are tracked already; no corner is given within min_distance_px of one. An even image has none.
std::vector<cv::Point2f> detect_corners(const cv::Mat& gray, const CornerOptions& options = {},
                                        const std::vector<cv::Point2f>& taken = {});

}  // namespace framewise
