// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/tracking_corners.h"

#include <opencv2/imgproc.hpp>

#include "framewise/features/tracking_input.h"

namespace framewise {
namespace {

// 255 where a corner may be.
cv::Mat free_of(const std::vector<cv::Point2f>& taken, const cv::Size& size, double distance) {
  cv::Mat mask(size, CV_8U, cv::Scalar(255));
  for (const cv::Point2f& p : taken)
    if (p.x > -1e4f && p.x < 1e6f && p.y > -1e4f && p.y < 1e6f)  // false for NaN
      cv::circle(mask, p, cvRound(distance), cv::Scalar(0), cv::FILLED);
  return mask;
}

}  // namespace

void CornerOptions::check() const {
  check_tracking_option(count >= 1, "count", count, "at least 1");
  check_tracking_option(quality > 0 && quality <= 1, "quality", quality, "more than 0, at most 1");
  check_tracking_option(min_distance_px >= 0 && min_distance_px <= 1e4, "min_distance_px", min_distance_px,
                        "0 to 10000");
  check_tracking_option(block >= 1 && block <= 31, "block", block, "1 to 31");
}

std::vector<cv::Point2f> detect_corners(const cv::Mat& gray, const CornerOptions& options,
                                        const std::vector<cv::Point2f>& taken) {
  options.check();
  check_tracking_image(gray);
  std::vector<cv::Point2f> corners;
  const cv::Mat mask = taken.empty() ? cv::Mat() : free_of(taken, gray.size(), options.min_distance_px);
  cv::goodFeaturesToTrack(gray, corners, options.count, options.quality, options.min_distance_px, mask,
                          options.block);
  return corners;
}

}  // namespace framewise
