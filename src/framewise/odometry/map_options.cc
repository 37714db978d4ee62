// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_options.h"

#include <stdexcept>
#include <string>

#include "framewise/features/feature_names.h"

namespace framewise {

void MapOptions::check() const {
  const auto require = [](bool holds, const char* name, double found, const char* expected) {
    if (!holds)
      throw std::invalid_argument(std::string(name) + ": found " + std::to_string(found) + ", expected " +
                                  expected);
  };
  require(keyframe_share > 0 && keyframe_share < 1, "keyframe-share", keyframe_share,
          "more than 0, less than 1");
  require(keyframe_shift > 0 && keyframe_shift < 1, "keyframe-shift", keyframe_shift,
          "more than 0, less than 1");
  require(features >= 50 && features <= 100000, "map-features", features, "50 to 100000");
  spread_of(spread);
  if (adjust != "always" && adjust != "never" && adjust != "auto")
    throw std::invalid_argument("adjust: found '" + adjust + "', expected always, never or auto");
  require(keyframes >= 2 && keyframes <= 1000, "keyframes", keyframes, "2 to 1000");
  require(newest >= 1 && newest <= keyframes, "newest-keyframes", newest, "1 or more, at most keyframes");
  require(others >= 0, "other-keyframes", others, "0 or more");
  require(points >= 50, "map-points", points, "at least 50");
  require(window_px > 0 && window_px < 1e4, "map-window-px", window_px, "more than 0, less than 10000");
  require(plane_reach_px >= 0 && plane_reach_px <= 20, "plane-reach-px", plane_reach_px, "0 to 20");
  require(look_again_px > 0, "look-again-px", look_again_px, "more than 0");
  require(least_sigma_px > 0, "least-sigma-px", least_sigma_px, "more than 0");
  require(min_inliers >= 8, "map-min-inliers", min_inliers, "at least 8");
  require(max_coast >= 0, "max-coast", max_coast, "at least 0");
}

}  // namespace framewise
