// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

// How much of an 8-bit gray image is picture: the root mean square difference of neighbouring means of 4 x 4
// pixels over what the noise of the pixels makes of it. 1: noise alone. The noise is the image's own,
//   Immerkaer, Fast noise variance estimation, CVIU 1996,
// the median over rows of pixels in place of the mean, as texture raises it; and at least that of rounding to
// 8 bits. 0 where the image is empty or has no two such means.
double contrast_to_noise(const cv::Mat& gray);

}  // namespace framewise
