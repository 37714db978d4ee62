// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "framewise/features/features.h"
#include "framewise/features/matching.h"
#include "framewise/features/tracking.h"
#include "framewise/geometry/depth_noise.h"
#include "framewise/image/depth.h"
#include "framewise/robust/ransac_options.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {

// How `framewise run` turns frames into a trajectory. The names are those of the command line.
struct OdometryOptions {
  // kabsch (3D-3D, metric), or from bearings alone: eight-point, seven-point, nister-5pt, stewenius-5pt,
  // kneip-5pt-rotation, eigensolver.
  std::string solver = "kabsch";
  std::string error = "default";  // kabsch: point-to-point; bearings: sampson
  std::string scale = "depth";    // length of a step from bearings: depth, truth or none (each step 1)
  FeatureOptions features;
  // brute-force: exact nearest descriptors; flann: approximate ones; windowed: exact among features within
  // match.window_px of the same pixel; klt: the first frame's features are tracked, nothing is described.
  std::string matcher = "brute-force";
  MatchOptions match;              // cross-check, ratio test, window; its matcher is chosen by the name above
  TrackOptions track;              // of klt
  std::string subpixel = "align";  // positions in the second image by aligning patches; or none
  DepthLookupOptions depth;
  RansacOptions ransac;
  std::string refine =
      "covariance";  // kabsch: after RANSAC the inliers again, each weighed by its noise; or none
  // Noise of a feature of the finest scale; coarser ones in proportion (pixels). What patches leave of it in
  // clean images is a tenth, in real ones with blur, noise and a rolling shutter it is this.
  double keypoint_sigma_px = 0.25;
  DepthNoise depth_noise;     // of the depth camera
  double max_error_m = 0.08;  // kabsch: two points farther apart than this disagree (m)
  double max_error_px = 1.5;  // bearings: likewise for the distance to the epipolar line (pixels)
  int min_inliers = 12;       // fewer agree by chance; the frame is lost
  double max_bridge = 1.0;    // how long the last good frame is kept as reference after a loss (s)
  int threads = 0;            // 0: all cores. The result does not depend on it
  std::uint64_t seed = 0;

  // Throws std::invalid_argument that names the value, what was found and what was expected.
  void check() const;

  bool tracks() const { return matcher == "klt"; }
  bool uses_points() const { return solver == "kabsch"; }
  RelativePoseSolver relative_pose_solver() const;  // of a solver that uses bearings
  bool needs_depth() const { return uses_points() || scale == "depth"; }
};

}  // namespace framewise
