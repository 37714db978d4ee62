// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace framewise {

struct DensifyOptions {
  // How far a depth may come from (pixels). A 64-line scanner's lines are 4 to 6 pixels apart at f = 720;
  // twice that bridges a lost line.
  int max_reach_px = 10;
  // Sigma of the samples' weights over their distance (pixels): about half of what lies between two lines.
  double sigma_px = 2.5;
  // Samples whose inverse depth differs from the nearest sample's by more than about this share belong to
  // another surface.
  double max_step = 0.1;
  int min_samples = 3;  // with fewer within the reach a pixel stays unknown

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// What a pixel of the mask says.
enum class DepthSource : unsigned char { kUnknown = 0, kInterpolated = 128, kMeasured = 255 };

struct DenseDepth {
  cv::Mat depth;  // CV_32F, NaN where unknown
  cv::Mat mask;   // CV_8U, DepthSource
};

// Sparse depth, such as a LiDAR's points in an image, to dense depth. At every unknown pixel a plane of
// inverse depth, w(du, dv) = a + b du + c dv, is fitted to the samples around, weighted by their distance and
// by how alike their inverse depth is to the nearest sample's; a is the answer, kept between the samples' own
// values. Planes in space are planes in inverse depth, so they come out exact, and edges stay edges.
//   Knutsson, Westin, Normalized and differential convolution, CVPR 1993 (the fit);
//   Ku, Harakeh, Waslander, In defense of classical image processing, CRV 2018 (the task).
// depth: CV_32F, unknown where NaN, infinite or not above 0; known pixels come out as they went in.
DenseDepth densify(const cv::Mat& depth, const DensifyOptions& options);

}  // namespace framewise
