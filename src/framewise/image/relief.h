// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "framewise/image/depth_rays.h"

namespace framewise {

struct ReliefOptions {
  int distance_px = 4;            // of the neighbours whose differences span the surface
  double smoothing_sigma_px = 0;  // of inverse depth before (pixels, see InverseDepthSmoothing); 0: none
  // From the surface to the light, in camera axes, any length: over the camera's left shoulder. shaded_relief
  // only.
  Eigen::Vector3d light{-1, -1, -1};

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// The surface's unit normal, towards the camera, from the differences d0 and d1 of flexion.h: its component
// against the optical axis, so 1 for a wall that is faced. Of an equirectangular camera, against the pixel's
// own ray.
cv::Mat normal_image(const cv::Mat& depth, const DepthRays& rays, const ReliefOptions& options);

// Lambert's law under the light: max(0, normal . light).
cv::Mat shaded_relief(const cv::Mat& depth, const DepthRays& rays, const ReliefOptions& options);

// Both: depth as for flexion_image; the answer CV_32F in [0, 1], NaN where it is not defined, as there.

}  // namespace framewise
