// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace framewise {

// Writes an image's features as text: a comment that names the image and the columns, then a line a keypoint,
//   x y size angle_deg response octave d0 d1 ...
// x, y and size in pixels ((0, 0) is the centre of the first), angle -1 where there is none, response and
// octave as the detector gives them, then the descriptor's values: bytes 0 to 255 (binary descriptors have
// eight bits in each) or shortest decimals that read back as the same floats; none where descriptors are
// empty. Throws InputError where the file cannot be written, std::invalid_argument where keypoints and
// descriptors (a row each, CV_8U or CV_32F) differ in number.
void write_features(const std::filesystem::path& file, const std::string& image_name,
                    const std::vector<cv::KeyPoint>& keypoints, const cv::Mat& descriptors);

}  // namespace framewise
