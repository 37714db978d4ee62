// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace framewise {
namespace {

TEST(MapOptions, DefaultsAreInOrder) { EXPECT_NO_THROW(MapOptions().check()); }

TEST(MapOptions, WhatMakesNoSenseIsNamedWithWhatWasFound) {
  const std::vector<std::pair<std::string, std::function<void(MapOptions&)>>> wrong = {
      {"keyframe-share: found 1", [](MapOptions& o) { o.keyframe_share = 1; }},
      {"keyframe-shift: found 0", [](MapOptions& o) { o.keyframe_shift = 0; }},
      {"map-features: found 3", [](MapOptions& o) { o.features = 3; }},
      {"keyframes: found 1", [](MapOptions& o) { o.keyframes = 1; }},
      {"map-points: found 5", [](MapOptions& o) { o.points = 5; }},
      {"map-window-px: found 0", [](MapOptions& o) { o.window_px = 0; }},
      {"plane-reach-px: found -1", [](MapOptions& o) { o.plane_reach_px = -1; }},
      {"look-again-px: found 0", [](MapOptions& o) { o.look_again_px = 0; }},
      {"least-sigma-px: found 0", [](MapOptions& o) { o.least_sigma_px = 0; }},
      {"map-min-inliers: found 2", [](MapOptions& o) { o.min_inliers = 2; }},
      {"max-coast: found -1", [](MapOptions& o) { o.max_coast = -1; }}};
  for (const auto& [said, spoil] : wrong) {
    MapOptions options;
    spoil(options);
    try {
      options.check();
      ADD_FAILURE() << said;
    } catch (const std::invalid_argument& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr(said));
      EXPECT_THAT(e.what(), testing::HasSubstr("expected"));
    }
  }
}

TEST(MapOptions, AdjustmentHasThreeNames) {
  MapOptions options;
  for (const char* name : {"auto", "always", "never"})
    EXPECT_NO_THROW((options.adjust = name, options.check()));
  options.adjust = "true";
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
