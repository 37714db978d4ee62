// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "framewise/features/box_hessian.h"

namespace framewise {

// The sums of an image over boxes from its corner: CV_32S, a row and a column larger (Crow, Summed-area
// tables for texture mapping, SIGGRAPH 1984). gray: CV_8U.
cv::Mat integral_image(const cv::Mat& gray);
Sums sums_of(const cv::Mat& integral);

// Blobs of an image: maxima over place and scale of the determinant of the Hessian by box filters, found to
// fractions of a pixel and of a scale, the strongest first.
//   Bay, Ess, Tuytelaars, Van Gool, Speeded-Up Robust Features (SURF), CVIU 2008, section 3.
// size of a keypoint is the side of the filter (pixels) that answers most, scale s = 1.2 size / 9 (a Gaussian
// blob of sigma answers most at s = 0.71 sigma: the lobes are as wide as those of a wider Gaussian); response
// the determinant (grey levels^2); class_id 1 for blobs brighter than their surroundings, -1 for darker ones;
// octave counts samplings at 1, 2, 4, 8 pixels; angle is -1. Does not depend on the number of threads.
std::vector<cv::KeyPoint> detect_fast_hessian(const cv::Mat& integral, float threshold);

}  // namespace framewise
