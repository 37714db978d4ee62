// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

// Throws std::invalid_argument that names an image that is empty or of another type (CV_32F, say) than
// expected.
void check_image(const char* name, const cv::Mat& image, int type);

// Likewise, for an image that must be width x height.
void check_image_size(const char* name, const cv::Mat& image, int width, int height);

}  // namespace framewise
