// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "framewise/image/depth_rays.h"
#include "framewise/image/surface_kernels.h"

namespace framewise {

// One pass over a depth image: rows are cleaned, smoothed and measured while they are in the cache.
struct SurfacePass {
  SurfaceMeasure measure = SurfaceMeasure::kFlexion;
  int distance_px = 1;
  double smoothing_sigma_px = 0;    // 0: none
  bool unknown_at_camera = false;   // else NaN
  Eigen::Vector3d light{0, 0, -1};  // unit, in camera axes; kNormal only
  bool light_along_ray = false;     // kSphere only: the light is where the camera is
};

// CV_32F, NaN where the measure is not defined; in the memory of `image` where that is of the right size and
// type.
cv::Mat measure_surface(const cv::Mat& depth, const DepthRays& rays, const SurfacePass& pass,
                        cv::Mat image = {});

// Throws std::invalid_argument that names the value.
void check_surface_options(int distance_px, double smoothing_sigma_px);

}  // namespace framewise
