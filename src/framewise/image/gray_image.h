// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

// Any common image as gray of 8 bits (CV_8U), as feature detectors read it. Colour (blue, green, red) is
// weighed as ITU-R BT.601 does; alpha is left out; of 16 bits the full range 0 to 65535 becomes 0 to 255.
// An 8-bit gray image comes back as it is, not copied; an empty one empty. Throws std::invalid_argument on 2
// channels or more than 4, and on floating point and signed pixels, whose range is not known.
cv::Mat gray_image(const cv::Mat& image);

}  // namespace framewise
