// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

// kNearest: the depth of the nearest known pixel; edges stay sharp, a hole's halves meet in a seam.
// kSmooth: inverse depth averaged from the rim over ever coarser levels, without seams.
//   Gortler et al., The lumigraph, SIGGRAPH 1996, section 3.4 (pull-push).
enum class FillMethod { kNearest, kSmooth };

struct FillOptions {
  FillMethod method = FillMethod::kSmooth;
  double max_reach_px = 0;  // what is farther from every known pixel stays unknown; 0: everything is filled

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// depth: CV_32F, unknown where NaN, infinite or not above 0. Known pixels come out as they went in; unknown
// ones filled, or NaN beyond the reach and in an image that knows nothing. What is filled is a guess: good
// for features, not for measuring.
cv::Mat fill_holes(const cv::Mat& depth, const FillOptions& options);

}  // namespace framewise
