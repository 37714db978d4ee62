// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace framewise {

// Images from files; an InputError names a file that is missing, cut short or not what it should be.

// CV_8U. Colour files are converted to gray.
cv::Mat read_gray(const std::filesystem::path& path);

// As stored: 1, 3 or 4 channels of 8 or 16 bits or float; an EXR's depth.
cv::Mat read_image(const std::filesystem::path& path);

// Depth as stored. CV_16U from a 16-bit PNG or TIFF: the caller knows the factor. CV_32F from a TIFF of
// floats or an EXR file (half or float; its channel Z, else the only or first one): metres.
cv::Mat read_depth_file(const std::filesystem::path& path);

// PNG (8 or 16 bits), TIFF (float) or any other that OpenCV writes, by the file's ending. Throws InputError
// where it cannot be written.
void write_image(const std::filesystem::path& path, const cv::Mat& image);

}  // namespace framewise
