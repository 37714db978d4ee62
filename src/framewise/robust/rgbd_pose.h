// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "framewise/geometry/depth_noise.h"
#include "framewise/robust/estimate.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

struct RgbdPoseOptions {
  RansacOptions ransac;
  double max_error = 2.0 / 525;  // reprojection error of an inlier: pixels / focal length
  std::optional<double>
      image_sigma;         // noise of an image coordinate (pixels / focal length); else from the data
  DepthNoise depth_noise;  // of both depth images
  int min_inliers = 6;     // fewer are no answer
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// Motion between two pinhole cameras with depth, from correspondences some of which are wrong: P3P on the
// points of camera 1, judged by their reprojection in camera 2, then least squares on what agrees, in which
// each correspondence counts with the noise of both its depths and of both its rays (refine_rgbd_pair.h).
// Rays x1, x2 of any length with z > 0; depths z1, z2 along the optical axis (m), NaN or 0 where there is
// none: such a correspondence adds what its rays say. Empty: fewer than 4 depths in camera 1, or too few
// inliers. Throws std::invalid_argument on sizes that differ, rays that are not finite or do not point
// forward, and infinite depths.
std::optional<Estimate> estimate_rgbd_pose(std::span<const Bearing> x1, std::span<const double> z1,
                                           std::span<const Bearing> x2, std::span<const double> z2,
                                           const RgbdPoseOptions& options = {});

}  // namespace framewise
