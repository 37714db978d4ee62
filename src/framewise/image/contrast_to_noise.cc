// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/contrast_to_noise.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "framewise/image/image_check.h"

namespace framewise {
namespace {

constexpr int kBlock = 4;

double noise_of(const cv::Mat& gray) {
  const cv::Matx33f second_differences(1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::Mat response;
  cv::filter2D(gray, response, CV_32F, second_differences);
  std::vector<double> rows;
  for (int v = 1; v + 1 < response.rows; ++v) rows.push_back(cv::mean(cv::abs(response.row(v)))[0]);
  if (rows.empty()) return 0;
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
  std::nth_element(rows.begin(), middle, rows.end());
  return std::sqrt(M_PI / 2) / 6 * *middle;
}

}  // namespace

double contrast_to_noise(const cv::Mat& gray) {
  if (gray.cols < 2 * kBlock || gray.rows < 2 * kBlock) return 0;
  check_image("gray", gray, CV_8U);
  cv::Mat means;
  cv::resize(gray, means, {gray.cols / kBlock, gray.rows / kBlock}, 0, 0, cv::INTER_AREA);
  means.convertTo(means, CV_32F);
  const cv::Mat across = means.colRange(1, means.cols) - means.colRange(0, means.cols - 1);
  const double contrast = cv::norm(across) / std::sqrt(static_cast<double>(across.total()));
  const double rounding = std::sqrt(1.0 / 12);
  return contrast / (std::max(noise_of(gray), rounding) * std::sqrt(2.0) / kBlock);
}

}  // namespace framewise
