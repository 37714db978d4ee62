// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {

struct TwoStageOptions {
  RelativePoseOptions first;            // solver, inlier measure, threshold and RANSAC of the first stage
  double second_max_error = 1.0 / 525;  // threshold of the second, tighter: pixels / focal length, or rad
  double second_confidence = 0.99;      // of the second stage; the eigensolver's differs from the first
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// The frame-to-frame scheme of laboratory comparisons: RANSAC, RANSAC again among its inliers with a tighter
// threshold, then one estimate by the solver itself from what remains.
//   8-point and eigensolver take all remaining inliers. Kneip's takes eight of them, drawn at random until
// twenty draws gave an answer, and gives only rotations: each gets its translation from all remaining
// inliers. Minimal solvers of essential matrices (5- and 7-point) give way to least squares on all remaining
// inliers. Of several solutions the one with the lowest score of the inlier measure is taken; when there is
// none, eight random inliers are drawn again, up to the iteration limit of the first stage. Local
// optimisation of the two RANSACs is first.ransac's; the comparisons of the literature have it off.
//   No
// degeneracy is looked for and there is no covariance: kind is kFull, as the scheme takes for granted. Empty:
// too few points or inliers at either stage, or no solution. Throws as estimate_relative_pose does.
std::optional<Estimate> estimate_relative_pose_two_stage(std::span<const Bearing> x1,
                                                         std::span<const Bearing> x2,
                                                         const TwoStageOptions& options = {});

}  // namespace framewise
