// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/blob_strengths.h"

#include <algorithm>
#include <functional>
#include <opencv2/imgproc.hpp>

namespace framewise {
namespace {

cv::Mat hessian_determinants(const cv::Mat& image) {
  cv::Mat determinants(image.size(), CV_32F, cv::Scalar(0));
  for (int y = 1; y < image.rows - 1; ++y) {
    const auto *above = image.ptr<float>(y - 1), *here = image.ptr<float>(y),
               *below = image.ptr<float>(y + 1);
    auto* determinant = determinants.ptr<float>(y);
    for (int x = 1; x < image.cols - 1; ++x) {
      const float xx = here[x + 1] + here[x - 1] - 2 * here[x], yy = above[x] + below[x] - 2 * here[x];
      const float xy = (above[x - 1] + below[x + 1] - above[x + 1] - below[x - 1]) / 4;
      determinant[x] = xx * yy - xy * xy;
    }
  }
  return determinants;
}

void add_maxima(const cv::Mat& values, const cv::Mat& mask, std::vector<float>& maxima) {
  for (int y = 1; y < values.rows - 1; ++y) {
    const auto *above = values.ptr<float>(y - 1), *here = values.ptr<float>(y),
               *below = values.ptr<float>(y + 1);
    for (int x = 1; x < values.cols - 1; ++x) {
      const float value = here[x];
      if (!(value > 0) || value <= here[x - 1] || value < here[x + 1]) continue;
      const float highest_around =
          std::max({above[x - 1], above[x], above[x + 1], below[x - 1], below[x], below[x + 1]});
      if (value >= highest_around && (mask.empty() || mask.at<std::uint8_t>(y, x) != 0))
        maxima.push_back(value);
    }
  }
}

}  // namespace

std::vector<float> blob_strengths(const cv::Mat& gray, const cv::Mat& mask,
                                  const BlobStrengthOptions& options) {
  std::vector<float> strengths;
  cv::Mat image = gray, halved_mask = mask;
  for (int level = 0; level < options.levels; ++level) {
    const cv::Size size(image.cols / 2, image.rows / 2);
    if (size.width < 3 || size.height < 3) break;
    cv::resize(image, image, size, 0, 0, cv::INTER_AREA);
    if (!mask.empty()) cv::resize(mask, halved_mask, size, 0, 0, cv::INTER_NEAREST);
    cv::Mat blurred;
    image.convertTo(blurred, CV_32F);
    cv::GaussianBlur(blurred, blurred, cv::Size(), options.sigma, options.sigma);
    add_maxima(hessian_determinants(blurred), halved_mask, strengths);
  }
  std::sort(strengths.begin(), strengths.end(), std::greater<>());
  return strengths;
}

}  // namespace framewise
