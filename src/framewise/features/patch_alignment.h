// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace framewise {

struct PatchAlignmentOptions {
  int window = 11;         // side of the patches compared (pixels, odd)
  double max_shift = 2.0;  // a position that wants to move farther was not the same corner (pixels)
};

// Corners are found at whole pixels; between neighbouring frames that is most of the error of a match. Moves
// each of pixels2 to where image 2 looks most like image 1 does around its partner in pixels1, to some
// hundredths of a pixel (Lucas and Kanade, IJCAI 1981, at the finest scale). What has no texture, leaves the
// image or would move more than max_shift stays where it is. gray1, gray2: CV_8U.
void align_patches(const cv::Mat& gray1, const cv::Mat& gray2, const std::vector<cv::Point2f>& pixels1,
                   std::vector<cv::Point2f>& pixels2, const PatchAlignmentOptions& options = {});

}  // namespace framewise
