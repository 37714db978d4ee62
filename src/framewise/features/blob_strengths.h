// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

struct BlobStrengthOptions {
  double sigma = 1.5;  // blur of each level (its pixels)
  int levels = 3;      // the image halved once, twice, ...
};

// The determinant of the Hessian (grey levels^2) where it is largest among its neighbours, at the levels of
// an image pyramid, strongest first. In a fiftieth of the time that a detector takes this tells how much
// there is to detect, and so the threshold at which so many keypoints will be found. mask: places that count
// (CV_8U, not 0), or empty.
std::vector<float> blob_strengths(const cv::Mat& gray, const cv::Mat& mask,
                                  const BlobStrengthOptions& options);

}  // namespace framewise
