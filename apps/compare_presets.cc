// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_presets.h"

#include <filesystem>
#include <map>

namespace framewise::apps {
namespace {

// "Frame-to-Frame Visual Odometry: The Importance of Local Transformations", tables 1 and 2: translation from
// centroids (C) or one scale from the first pair (S), inliers by bearings (E) or reprojection (R).
constexpr const char* kFrameToFrame = R"(
axes:
  scale: {C: centroid, S: first-pair}
  error: {E: bearing-euclidean, R: reprojection}
  solver: {Eigensolver: eigensolver, Kneip: kneip-5pt-rotation, nister: nister-5pt, eight-point: eight-point}
  ransac: two-stage
rows:
  - {name: Kabsch, solver: kabsch}
features:
  - {name: AKAZE, detector: akaze, descriptor: akaze}
  - {name: ORB, detector: orb, descriptor: orb}
  - {name: SURF, detector: surf, descriptor: surf}
)";

// A laboratory's four estimators with and without RANSAC, their steps scaled by the true length.
constexpr const char* kLab = R"(
rows:
  - {name: 5-point, solver: nister-5pt, scale: truth, ransac: {RANSAC: on, no RANSAC: off}}
  - {name: 8-point, solver: eight-point, scale: truth, ransac: {RANSAC: on, no RANSAC: off}}
  - {name: 2-point, solver: two-point, rotation: truth, scale: truth, ransac: {RANSAC: on, no RANSAC: off}}
  - {name: Arun, solver: kabsch, max-error-m: 0.1, ransac: {RANSAC: on, no RANSAC: off}}
features:
  - {name: SIFT, detector: sift, descriptor: sift, matcher: flann}
)";

// Features where there is no light: in depth images and in flexion images, first as they were published, then
// with holes filled and surfaces smoothed.
constexpr const char* kDark = R"(
rows:
  - solver: kabsch
    input: {depth as it is: depth-raw, flexion as published: flexion-published, depth: depth, flexion: flexion, normal: normal}
features:
  - {name: SIFT, detector: sift, descriptor: sift, matcher: brute-force}
  - {name: AKAZE, detector: akaze, descriptor: akaze, matcher: brute-force}
  - {name: ORB, detector: orb, descriptor: orb, matcher: brute-force}
)";

}  // namespace

Grid grid_from_name(const std::string& name) {
  const std::map<std::string, const char*> presets = {
      {"frame-to-frame", kFrameToFrame}, {"lab", kLab}, {"dark", kDark}};
  if (const auto preset = presets.find(name); preset != presets.end())
    return parse_grid(preset->second, name);
  return read_grid_file(name);
}

}  // namespace framewise::apps
