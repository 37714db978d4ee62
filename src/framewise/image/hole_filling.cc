// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/hole_filling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "framewise/image/depth.h"
#include "framewise/image/image_check.h"

namespace framewise {
namespace {

// CV_8U: 0 where the depth is known, else 1.
cv::Mat unknown_mask(const cv::Mat& depth) {
  cv::Mat mask(depth.size(), CV_8U);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) mask.at<std::uint8_t>(v, u) = !is_known_depth(depth.at<float>(v, u));
  return mask;
}

cv::Mat nearest_known(const cv::Mat& depth, const cv::Mat& unknown) {
  cv::Mat distance, labels;
  cv::distanceTransform(unknown, distance, labels, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
  std::vector<float> depth_of(static_cast<std::size_t>(depth.total()) + 1, kUnknownDepth);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u)
      if (!unknown.at<std::uint8_t>(v, u)) depth_of[labels.at<int>(v, u)] = depth.at<float>(v, u);
  cv::Mat filled(depth.size(), CV_32F);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) filled.at<float>(v, u) = depth_of[labels.at<int>(v, u)];
  return filled;
}

// Half the size, rounded up: the mean of what is known (above 0) of each four pixels, else 0.
cv::Mat pull(const cv::Mat& fine) {
  cv::Mat coarse((fine.rows + 1) / 2, (fine.cols + 1) / 2, CV_32F);
  for (int v = 0; v < coarse.rows; ++v) {
    const float* rows[] = {fine.ptr<float>(2 * v), fine.ptr<float>(std::min(2 * v + 1, fine.rows - 1))};
    for (int u = 0; u < coarse.cols; ++u) {
      const int right = std::min(2 * u + 1, fine.cols - 1);
      float sum = 0;
      int known = 0;
      for (const float* row : rows)
        for (const float value : {row[2 * u], row[right]}) {
          sum += value;
          known += value > 0;
        }
      coarse.at<float>(v, u) = known > 0 ? sum / static_cast<float>(known) : 0;
    }
  }
  return coarse;
}

// What is unknown at the fine level becomes the bilinear value of the coarse one, which knows everything.
void push(const cv::Mat& coarse, cv::Mat& fine) {
  for (int v = 0; v < fine.rows; ++v) {
    // The centre of a fine pixel lies a quarter of a coarse one beside the centre of its own.
    const float* own = coarse.ptr<float>(v / 2);
    const float* other = coarse.ptr<float>(std::clamp(v / 2 + (v % 2 ? 1 : -1), 0, coarse.rows - 1));
    float* out = fine.ptr<float>(v);
    for (int u = 0; u < fine.cols; ++u) {
      if (out[u] > 0) continue;
      const int i = u / 2, j = std::clamp(i + (u % 2 ? 1 : -1), 0, coarse.cols - 1);
      out[u] = 0.75f * (0.75f * own[i] + 0.25f * own[j]) + 0.25f * (0.75f * other[i] + 0.25f * other[j]);
    }
  }
}

cv::Mat pull_push(const cv::Mat& depth, const cv::Mat& unknown) {
  std::vector<cv::Mat> levels(1, cv::Mat(depth.size(), CV_32F));
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u)
      levels[0].at<float>(v, u) = unknown.at<std::uint8_t>(v, u) ? 0 : 1 / depth.at<float>(v, u);
  while (levels.back().total() > 1) levels.push_back(pull(levels.back()));
  for (std::size_t level = levels.size() - 1; level-- > 0;) push(levels[level + 1], levels[level]);
  return 1 / levels[0];
}

}  // namespace

void FillOptions::check() const {
  if (!(max_reach_px >= 0) || !std::isfinite(max_reach_px))
    throw std::invalid_argument("max_reach_px: found " + std::to_string(max_reach_px) +
                                ", expected at least 0");
}

cv::Mat fill_holes(const cv::Mat& depth, const FillOptions& options) {
  check_image("depth", depth, CV_32F);
  options.check();
  const cv::Mat unknown = unknown_mask(depth);
  const int holes = cv::countNonZero(unknown);
  cv::Mat filled = depth.clone();
  if (holes == 0) return filled;
  if (holes == static_cast<int>(depth.total())) return filled.setTo(kUnknownDepth);
  const cv::Mat guess =
      options.method == FillMethod::kNearest ? nearest_known(depth, unknown) : pull_push(depth, unknown);
  guess.copyTo(filled, unknown);
  if (options.max_reach_px > 0) {
    cv::Mat distance;
    cv::distanceTransform(unknown, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    filled.setTo(kUnknownDepth, distance > options.max_reach_px);
  }
  return filled;
}

}  // namespace framewise
