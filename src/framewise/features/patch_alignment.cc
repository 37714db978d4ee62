// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/patch_alignment.h"

#include <opencv2/video/tracking.hpp>

namespace framewise {

void align_patches(const cv::Mat& gray1, const cv::Mat& gray2, const std::vector<cv::Point2f>& pixels1,
                   std::vector<cv::Point2f>& pixels2, const PatchAlignmentOptions& options) {
  if (pixels1.empty()) return;
  std::vector<cv::Point2f> moved = pixels2;
  std::vector<std::uint8_t> found;
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 10, 0.01);
  constexpr int kFinestLevelOnly = 0;
  cv::calcOpticalFlowPyrLK(gray1, gray2, pixels1, moved, found, cv::noArray(),
                           cv::Size(options.window, options.window), kFinestLevelOnly, until,
                           cv::OPTFLOW_USE_INITIAL_FLOW);
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (found[i] && cv::norm(moved[i] - pixels2[i]) <= options.max_shift) pixels2[i] = moved[i];
}

}  // namespace framewise
