// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace framewise {

// Images from files; an InputError names a file that is missing, cut short or not what it should be.

// CV_8U. Colour files are converted to gray.
cv::Mat read_gray(const std::filesystem::path& path);

// CV_16U, as stored: the caller knows the factor.
cv::Mat read_depth16(const std::filesystem::path& path);

// By the ending of its name. Throws InputError where it cannot be written.
void write_image(const std::filesystem::path& path, const cv::Mat& image);

}  // namespace framewise
