// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/imgproc.hpp>

// Images to recognise things in.
namespace framewise::testing {

// Discs of many sizes and greys, with some noise.
inline cv::Mat discs(const cv::Size& size, std::uint64_t seed, int count) {
  cv::Mat image(size, CV_8U, cv::Scalar(110));
  cv::RNG rng(seed);
  for (int i = 0; i < count; ++i) {
    const cv::Point center(rng.uniform(0, size.width), rng.uniform(0, size.height));
    cv::circle(image, center, rng.uniform(2, 14), cv::Scalar(rng.uniform(0, 256)), cv::FILLED, cv::LINE_AA);
    const cv::Point corner(rng.uniform(0, size.width), rng.uniform(0, size.height));
    cv::rectangle(image, corner, corner + cv::Point(rng.uniform(3, 25), rng.uniform(3, 25)),
                  cv::Scalar(rng.uniform(0, 256)), cv::FILLED);
  }
  cv::Mat noise(size, CV_8S);
  rng.fill(noise, cv::RNG::NORMAL, 0, 2);
  cv::GaussianBlur(image, image, cv::Size(), 0.7);
  cv::add(image, noise, image, cv::noArray(), CV_8U);
  return image;
}

// The image turned (degrees, clockwise as one sees it) and enlarged about its centre; `to` maps places.
struct Turned {
  cv::Mat image;
  cv::Matx23d to;

  cv::Point2d operator()(const cv::Point2d& p) const {
    return {to(0, 0) * p.x + to(0, 1) * p.y + to(0, 2), to(1, 0) * p.x + to(1, 1) * p.y + to(1, 2)};
  }
};

inline Turned turned(const cv::Mat& image, double degrees, double enlarged) {
  const cv::Point2f center((image.cols - 1) / 2.0f, (image.rows - 1) / 2.0f);
  const cv::Mat to = cv::getRotationMatrix2D(center, -degrees, enlarged);
  Turned result{{}, cv::Matx23d(to.ptr<double>())};
  cv::warpAffine(image, result.image, to, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  return result;
}

}  // namespace framewise::testing
