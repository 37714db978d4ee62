// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "framewise/features/features.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/image/depth.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

// How `framewise run` turns frames into a trajectory. The names are those of the command line.
struct OdometryOptions {
  std::string solver = "kabsch";  // kabsch (3D-3D, metric) or eight-point (bearings alone)
  std::string error = "default";  // kabsch: point-to-point; eight-point: sampson
  std::string scale = "depth";    // length of an eight-point step: depth, truth or none (each step 1)
  FeatureOptions features;
  std::string matcher = "brute-force";  // exact, with cross-check
  DepthLookupOptions depth;
  RansacOptions ransac;
  std::string refine =
      "covariance";  // kabsch: after RANSAC the inliers again, each weighed by its noise; or none
  double keypoint_sigma_px =
      0.5;                    // noise of a feature of the finest scale; coarser ones in proportion (pixels)
  DepthNoise depth_noise;     // of the depth camera
  double max_error_m = 0.08;  // kabsch: two points farther apart than this disagree (m)
  double max_error_px = 1.5;  // eight-point: likewise for the distance to the epipolar line (pixels)
  int min_inliers = 12;       // fewer agree by chance; the frame is lost
  double max_bridge = 1.0;    // how long the last good frame is kept as reference after a loss (s)
  int threads = 0;            // 0: all cores. The result does not depend on it
  std::uint64_t seed = 0;

  // Throws std::invalid_argument that names the value, what was found and what was expected.
  void check() const;

  bool needs_depth() const { return solver == "kabsch" || scale == "depth"; }
};

}  // namespace framewise
