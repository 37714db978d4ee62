// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "framewise/features/warped_patch.h"

namespace framewise {

struct PatchSearchOptions {
  int radius = 3;                // as of track_patch; a smaller one bears more of what a wrong depth bends
  double min_correlation = 0.7;  // normalised; the place is refined and judged again by track_patch
  // The second best place, apart from the best, must differ by so many times as much: 1 - correlation.
  double min_distinction = 1.4;
  int max_places = 256;  // looked at; a longer segment is looked at less closely
};

// Where on the segment of image 2 from warp.pixel2 to `end` it looks most like the warped patch of image 1,
// to about a pixel of the level; empty where nowhere, or where another place does nearly as much.
std::optional<Eigen::Vector2d> search_patch(const ImageLevels& image1, const ImageLevels& image2,
                                            const PatchWarp& warp, const Eigen::Vector2d& end,
                                            const PatchSearchOptions& options = {});

}  // namespace framewise
