// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace framewise {

// The two images side by side (CV_8UC3, blue green red; dimmed and gray) with a thin line from each pixel of
// the first to its partner in the second: green for inliers, red for the others, which lie below. inliers:
// one for each match, or empty where none agree. Matches outside the images are left out. Throws
// std::invalid_argument where an image is empty or neither CV_8U nor CV_8UC3, and where the numbers differ.
cv::Mat draw_matches(const cv::Mat& image1, const cv::Mat& image2,
                     const std::vector<Eigen::Vector2d>& pixels1, const std::vector<Eigen::Vector2d>& pixels2,
                     const std::vector<std::uint8_t>& inliers);

}  // namespace framewise
