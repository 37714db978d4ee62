// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

// SURF's orientation and description of places of an image at a scale s: Bay, Ess, Tuytelaars, Van Gool,
// Speeded-Up Robust Features (SURF), CVIU 2008, section 4. size of a keypoint is 9 s / 1.2 (pixels), as the
// Fast-Hessian detector has it. Box sums are taken between pixels (sums are linear within one), so scales and
// places are not rounded. integral: as of integral_image. Does not depend on the number of threads.

// Sets the angle (degrees, clockwise from the x axis) of every keypoint: the direction in which most of the
// Haar wavelet responses within 6 s point.
void orient_surf(const cv::Mat& integral, std::vector<cv::KeyPoint>& keypoints);

struct SurfDescriptorOptions {
  bool extended = false;  // 128 values, sums kept apart by the other derivative's sign; else 64
  bool upright = false;   // angles are not read: the window is that of the image
};

// A row of unit length (CV_32F) for every keypoint: in 4 x 4 parts of a window of 20 s, turned by the angle,
// the sums of dx, dy, |dx|, |dy|. Where the window leaves the image, the image's edge is continued. Without
// any contrast the row is 0.
cv::Mat describe_surf(const cv::Mat& integral, const std::vector<cv::KeyPoint>& keypoints,
                      const SurfDescriptorOptions& options = {});

}  // namespace framewise
