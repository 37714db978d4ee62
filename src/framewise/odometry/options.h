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
#include "framewise/odometry/map_options.h"
#include "framewise/robust/ransac_options.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {

// How `framewise run` turns frames into a trajectory. The names are those of the command line.
struct OdometryOptions {
  // What a frame is related to. frame: the frame before it, by the solver below. map: a local map of the
  // frames before (map_odometer.h), which has its own method.
  std::string reference = "frame";
  MapOptions map;
  // With depth, metric: kabsch (3D-3D), p3p (3D-2D). From bearings alone: eight-point, seven-point,
  // nister-5pt, stewenius-5pt, kneip-5pt-rotation, eigensolver, opencv-essential (essential_by_opencv.h), and
  // two-point, which is given the rotation.
  std::string solver = "kabsch";
  // What makes an inlier. kabsch: point-to-point; p3p: reprojection; bearings: sampson, reprojection or
  // bearing-euclidean (two-point: sampson). default: the first of these.
  std::string error = "default";
  // Length of a step from bearings: depth, centroid, first-pair, truth or none (scale.h).
  std::string scale = "depth";
  // on; two-stage: twice, the second time at half the threshold, then the solver itself on what is left
  // (two_stage.h); off: one sample, no correspondence rejected (single_sample.h).
  std::string ransac_scheme = "on";
  std::string input = "color";  // the image that features are looked for in (input_image.h)
  // Steps refined by the surfaces of the depth images (geometric_refinement.h): frame (to frame), model (to a
  // keyframe's surface), none; auto: model where the input is made of depth, none where it is colour.
  std::string geometry = "auto";
  FeatureOptions features;
  // brute-force: exact nearest descriptors; flann: approximate ones; windowed: exact among features within
  // match.window_px of the same pixel; klt: the first frame's features are tracked, nothing is described;
  // auto: windowed in images made of depth, which repeat themselves, brute-force in colour.
  std::string matcher = "auto";
  MatchOptions match;              // cross-check, ratio test, window; its matcher is chosen by the name above
  TrackOptions track;              // of klt
  std::string subpixel = "align";  // positions in the second image by aligning patches; or none
  DepthLookupOptions depth;
  RansacOptions ransac;
  std::string refine = "covariance";  // after RANSAC the inliers again, each weighed by its noise; or none
  // Noise of a feature of the finest scale; coarser ones in proportion (pixels). What patches leave of it in
  // clean images is a tenth, in real ones with blur, noise and a rolling shutter it is this.
  double keypoint_sigma_px = 0.25;
  DepthNoise depth_noise;     // of the depth camera
  double max_error_m = 0.08;  // kabsch: two points farther apart than this disagree (m)
  double max_error_px = 1.5;  // sampson and reprojection: likewise (pixels)
  // bearing-euclidean: likewise for |x2 - R x1|, which holds the parallax as well, so far wider (rad).
  double max_error_rad = 0.03;
  int min_inliers = 12;     // fewer agree by chance; the frame is lost
  double max_bridge = 1.0;  // how long the last good frame is kept as reference after a loss (s)
  int threads = 0;          // 0: all cores. The result does not depend on it
  std::uint64_t seed = 0;

  // Throws std::invalid_argument that names the value, what was found and what was expected.
  void check() const;

  bool uses_surfaces() const;
  bool uses_surface_model() const;
  // The matcher for features found in an image of that name; still auto where that is auto itself, frame by
  // frame.
  std::string matcher_for(const std::string& input_name) const;
  bool tracks() const { return matcher == "klt"; }
  bool is_metric() const { return solver == "kabsch" || solver == "p3p"; }
  bool needs_rotation() const { return solver == "two-point"; }
  RelativePoseSolver relative_pose_solver() const;  // of a solver that uses bearings
  InlierMeasure inlier_measure() const;             // likewise
  // Whether a frame without depth has no step; scale first-pair only needs one pair with depth.
  bool needs_depth() const { return is_metric() || scale == "depth" || scale == "centroid"; }

 private:
  void check_method() const;
};

}  // namespace framewise
