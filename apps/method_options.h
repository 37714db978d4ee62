// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "framewise/odometry/options.h"

namespace framewise::apps {

// The one list of what `run` and `relpose` take, what they write down and what an archive remembers. An
// option is visit(name, field, help).

// Options that shape features and matches: an archive is made with them, and keeps them.
template <typename Visit>
void visit_correspondence_options(OdometryOptions& o, Visit&& visit) {
  visit("input", o.input,
        "image that features are looked for in: color, or of depth alone: depth, depth-raw,\n"
        "flexion, flexion-published or normal; auto: color where it shows more than noise, else normal");
  visit("detector", o.features.detector, "sift, surf, orb or akaze");
  visit("descriptor", o.features.descriptor, "sift, surf, surf-128, orb or akaze, with any detector");
  visit("features", o.features.count, "features asked for in a frame");
  visit("spread", o.features.spread, "features over the image: none (the strongest), grid or anms");
  visit("upright", o.features.upright, "descriptors are not turned into the feature's direction");
  visit("matcher", o.matcher,
        "brute-force (exact), flann (approximate), windowed (exact near the same pixel) or klt (tracked);\n"
        "auto: windowed where the input is made of depth, else brute-force");
  visit("cross-check", o.match.cross_check, "both features must choose each other");
  visit("ratio", o.match.max_ratio, "nearest to second nearest distance must be below; 1: any");
  visit("window-px", o.match.window_px, "windowed: how far a feature may have moved");
  visit("subpixel", o.subpixel, "matches to fractions of a pixel: align (patches), or none");
  visit("keypoint-sigma-px", o.keypoint_sigma_px, "noise of a feature's position at its finest scale");
  visit("depth-border-px", o.depth.border_px, "depth this near to the image's border is not used");
  visit("depth-max-edge", o.depth.max_edge, "depth jump that makes an edge, as a share of the depth");
  visit("min-depth", o.depth.min_depth, "nearer points are not used (m)");
  visit("max-depth", o.depth.max_depth, "farther points are not used (m)");
}

// Options of what is made of the matches.
template <typename Visit>
void visit_solver_options(OdometryOptions& o, Visit&& visit) {
  visit("geometry", o.geometry,
        "steps refined by the depth images' surfaces: frame (to frame), model (to a keyframe's surface),\n"
        "none; auto: model where the input is made of depth");
  visit(
      "solver", o.solver,
      "with depth: kabsch (3D-3D), p3p (3D-2D); from bearings: eight-point, seven-point, nister-5pt,\n"
      "stewenius-5pt, kneip-5pt-rotation, eigensolver, opencv-essential, two-point (the rotation is known)");
  visit("scale", o.scale, "length of a step from bearings: depth, centroid, first-pair, truth or none");
  visit("error", o.error,
        "what makes an inlier: point-to-point (kabsch), reprojection (p3p);\n"
        "bearings: sampson (default), reprojection or bearing-euclidean");
  visit("ransac", o.ransac_scheme,
        "on, two-stage (again at half the threshold, then the solver on what is left),\n"
        "or off (one sample, nothing rejected)");
  visit("refine", o.refine, "the inliers once more, weighed by their noise: covariance, or none");
  visit("depth-noise-floor", o.depth_noise.floor, "sigma_z = floor + growth (z - 0.4 m)^2 (m)");
  visit("depth-noise-growth", o.depth_noise.growth, "sigma_z = floor + growth (z - 0.4 m)^2 (1/m)");
  visit("max-error-m", o.max_error_m, "largest point-to-point error of an inlier (m)");
  visit("max-error-px", o.max_error_px, "largest sampson or reprojection error of an inlier (pixels)");
  visit("max-error-rad", o.max_error_rad, "largest bearing-euclidean error of an inlier (rad)");
  visit("min-inliers", o.min_inliers, "with fewer a frame is lost");
  visit("max-bridge", o.max_bridge, "how long a good frame stays the reference after a loss (s)");
  visit("confidence", o.ransac.confidence, "RANSAC stops at this probability");
  visit("min-iterations", o.ransac.min_iterations, "RANSAC tries at least this many");
  visit("max-iterations", o.ransac.max_iterations, "RANSAC stops at this many");
  visit("threads", o.threads, "0: all cores; does not change the result");
  visit("seed", o.seed, "of every random choice");
}

// Options of the local map, which `run` takes when a frame is related to one.
template <typename Visit>
void visit_map_options(OdometryOptions& o, Visit&& visit) {
  visit("shrink", o.map.shrink, "map: poses towards the motion before, by both uncertainties");
  visit("adjust", o.map.adjust,
        "map: the last keyframes and their points together: always, never, or auto (with depth only while "
        "each frame becomes a keyframe)");
  visit("fuse", o.map.fuse, "map: depth of later frames into the points");
  visit("follow-delay", o.map.follow, "map: depth to where the camera was when it was taken");
  visit("unskew", o.map.unskew, "map: a rolling shutter's rows, by a readout that is learned");
  visit("learn-lens", o.map.learn_lens,
        "map: what the calibration leaves of the lens, learned without depth");
  visit("map-features", o.map.features, "map: features of a keyframe");
  visit("map-spread", o.map.spread, "map: features over the image: none, grid or anms");
  visit("keyframe-share", o.map.keyframe_share, "map: one that sees less of the last keyframe becomes one");
  visit("keyframe-shift", o.map.keyframe_shift,
        "map: without depth one whose motion shifted the image by this share of its width as well");
  visit("keyframes", o.map.keyframes, "map: keyframes that are kept");
  visit("newest-keyframes", o.map.newest, "map: of them tracked against whatever they see");
  visit("other-keyframes", o.map.others, "map: and those most in view");
  visit("map-points", o.map.points, "map: points tracked in a frame");
  visit("map-window-px", o.map.window_px, "map: how far from where it is expected a point is looked for");
  visit("plane-reach-px", o.map.plane_reach_px,
        "map: depths and warps from the plane this far around a point; 0: from its pixel");
  visit("look-again-px", o.map.look_again_px,
        "map: a pose that shifts what is seen by more has its patches looked for again (pixels)");
  visit("least-sigma-px", o.map.least_sigma_px, "map: least noise of a tracked point (pixels)");
  visit("map-min-inliers", o.map.min_inliers, "map: with fewer a frame is not measured");
  visit("max-coast", o.map.max_coast, "map: how long the motion goes on unmeasured (s)");
}

void add_method_options(CLI::App& app, OdometryOptions& options);
void add_map_options(CLI::App& app, OdometryOptions& options);

// The options that were chosen of those that say how two frames are related: then no map is asked for.
std::vector<std::string> method_options_chosen(const CLI::App& app);

// The matcher by the name that auto stands for.
nlohmann::ordered_json options_json(OdometryOptions options);
nlohmann::ordered_json map_options_json(OdometryOptions options);

// The options that shape correspondences, as text: what an archive keeps of them, the
// matcher likewise.
std::map<std::string, std::string> correspondence_option_texts(OdometryOptions options);

}  // namespace framewise::apps
