// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/geometry/depth_noise.h"
#include "framewise/odometry/local_map.h"

namespace framewise {

struct WindowOptions {
  DepthNoise depth_noise;
  int max_iterations = 5;     // it begins near its end, from the last window
  double tolerance = 1e-3;    // done at a step that promises a smaller share of the cost
  double loss_threshold = 2;  // of Cauchy's loss (standard deviations)
  // What is known of the lens's k1 but for these views (1/sigma^2); negative: k1 is as the rays have it.
  double lens_information = -1;
};

// Bundle adjustment of some keyframes and of all points they see: each keyframe's pose and each point's
// inverse depth in its host, so that views agree with the points, and points with the depth they were
// measured at, and on demand how far all rays are off for a lens that bends otherwise than was said,
// ray (1 - k1 |ray|^2): what it leaves bends a map, and in each turn changes its scale.
//   argmin sum rho(|pi(X) - ray|^2 / sigma^2 + (z - X_z)^2 / sigma_z^2)
//        + sum rho((inverse_z - measured)^2 information).
// A point is one number, so that eliminating the points leaves the poses alone (Triggs et al., Bundle
// adjustment - a modern synthesis, 2000, section 6.1). Keyframes that are not `moving` stay where they are;
// one at least must. Views that disagree with the answer are taken from the points. The order of the sums is
// that of the map: the same bytes every time.
struct WindowSummary {
  int views = 0, iterations = 0;
  double first_cost = 0, cost = 0;
  // How far the lens's first radial coefficient is from what the rays were made with, and what is known of it
  // now.
  double lens_correction = 0, lens_information = 0;
};
WindowSummary adjust_window(LocalMap& map, const std::vector<int>& moving, const std::vector<int>& still,
                            const WindowOptions& options = {});

}  // namespace framewise
