// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/match_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace framewise {
namespace {

const cv::Scalar kInlier(90, 230, 60), kOutlier(70, 60, 235);  // blue green red
constexpr double kLineOpacity = 0.45;                          // hundreds of lines must not hide the images
constexpr double kDim = 0.75;                                  // of the images, so that lines stand out
constexpr int kFraction = 4;                                   // bits of a pixel that lines are drawn to
constexpr double kDotRadius = 1.5;                             // pixels

void check_drawing(bool holds, const char* name, const std::string& found, const char* expected) {
  if (!holds) throw std::invalid_argument(std::string(name) + ": found " + found + ", expected " + expected);
}

void paste(const cv::Mat& image, cv::Mat canvas, const char* name) {
  check_drawing(!image.empty() && (image.type() == CV_8U || image.type() == CV_8UC3), name,
                "type " + std::to_string(image.type()) + " of " + std::to_string(image.total()) + " pixels",
                "an image of CV_8U or CV_8UC3");
  cv::Mat gray = image;
  if (image.channels() == 3) cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  gray.convertTo(gray, CV_8U, kDim);
  cv::cvtColor(gray, canvas, cv::COLOR_GRAY2BGR);
}

bool is_inside(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < image.cols - 0.5 &&
         pixel.y() < image.rows - 0.5;
}

cv::Point fixed_point(const Eigen::Vector2d& pixel) {
  return {cvRound(std::ldexp(pixel.x(), kFraction)), cvRound(std::ldexp(pixel.y(), kFraction))};
}

// Where each match that is inside both images lies on the canvas; the others below the inliers.
struct DrawnMatch {
  cv::Point from, to;
  cv::Scalar color;
};

}  // namespace

cv::Mat draw_matches(const cv::Mat& image1, const cv::Mat& image2,
                     const std::vector<Eigen::Vector2d>& pixels1, const std::vector<Eigen::Vector2d>& pixels2,
                     const std::vector<std::uint8_t>& inliers) {
  check_drawing(pixels2.size() == pixels1.size(), "pixels2", std::to_string(pixels2.size()),
                "as many as pixels1");
  check_drawing(inliers.empty() || inliers.size() == pixels1.size(), "inliers",
                std::to_string(inliers.size()), "none or as many as pixels1");
  cv::Mat canvas(std::max(image1.rows, image2.rows), image1.cols + image2.cols, CV_8UC3, cv::Scalar::all(0));
  paste(image1, canvas(cv::Rect(0, 0, image1.cols, image1.rows)), "image1");
  paste(image2, canvas(cv::Rect(image1.cols, 0, image2.cols, image2.rows)), "image2");

  std::vector<DrawnMatch> drawn;
  const Eigen::Vector2d beside(image1.cols, 0);
  for (const bool inlier : {false, true})
    for (std::size_t i = 0; i < pixels1.size(); ++i)
      if ((!inliers.empty() && inliers[i] != 0) == inlier && is_inside(image1, pixels1[i]) &&
          is_inside(image2, pixels2[i]))
        drawn.push_back(
            {fixed_point(pixels1[i]), fixed_point(pixels2[i] + beside), inlier ? kInlier : kOutlier});

  cv::Mat lines = canvas.clone();
  for (const DrawnMatch& match : drawn)
    cv::line(lines, match.from, match.to, match.color, 1, cv::LINE_AA, kFraction);
  cv::addWeighted(lines, kLineOpacity, canvas, 1 - kLineOpacity, 0, canvas);
  for (const DrawnMatch& match : drawn)
    for (const cv::Point& end : {match.from, match.to})
      cv::circle(canvas, end, cvRound(std::ldexp(kDotRadius, kFraction)), match.color, cv::FILLED,
                 cv::LINE_AA, kFraction);
  return canvas;
}

}  // namespace framewise
