// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/taken_places.h"

#include <algorithm>
#include <cmath>

namespace framewise {

TakenPlaces::TakenPlaces(cv::Size image, double apart_px)
    : free_(image, CV_8U, cv::Scalar(1)), reach_(static_cast<int>(apart_px)) {}

void TakenPlaces::take(const Eigen::Vector2d& pixel) {
  constexpr double kFarAway = 1e6;  // what is as far is not in any image, nor a number of pixels
  if (!(pixel.cwiseAbs().maxCoeff() < kFarAway)) return;
  const cv::Rect around(static_cast<int>(pixel.x()) - reach_, static_cast<int>(pixel.y()) - reach_,
                        2 * reach_ + 1, 2 * reach_ + 1);
  free_(around & cv::Rect(0, 0, free_.cols, free_.rows)).setTo(0);
}

bool TakenPlaces::is_free(const Eigen::Vector2d& pixel) const {
  const int u = std::clamp(static_cast<int>(std::lround(pixel.x())), 0, free_.cols - 1);
  const int v = std::clamp(static_cast<int>(std::lround(pixel.y())), 0, free_.rows - 1);
  return free_.at<std::uint8_t>(v, u) != 0;
}

}  // namespace framewise
