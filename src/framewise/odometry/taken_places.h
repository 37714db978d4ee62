// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace framewise {

// Where in an image points are already: others keep their distance, so that they say something else.
class TakenPlaces {
 public:
  TakenPlaces(cv::Size image, double apart_px);

  // A pixel, in the image or not, and all that is at most apart_px off it in u and in v.
  void take(const Eigen::Vector2d& pixel);

  // Of a pixel in the image.
  bool is_free(const Eigen::Vector2d& pixel) const;

 private:
  cv::Mat free_;
  int reach_;
};

}  // namespace framewise
