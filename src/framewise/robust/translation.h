// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

struct TranslationOptions {
  RansacOptions ransac;
  double max_error = 2.0 / 525;  // Sampson's distance of an inlier: pixels / focal length, or rad
  int min_inliers = 6;           // fewer are no answer
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// Direction of the translation between two views whose rotation R = cam2_from_cam1 is known, from
// corresponding bearings (of any length), some of them wrong: lambda2 x2 = R (lambda1 x1) + t, |t| = 1. Two
// points in RANSAC, then least squares on all inliers with the covariance of that (the rotation's part is 0:
// it was given). kind is kLowParallax where the direction is known to no better than 10 deg. Empty: fewer
// than 2 points, no parallax, or too few inliers. Throws std::invalid_argument on sizes that differ, on
// numbers that are not finite, on bearings of length zero and on a matrix that is no rotation.
std::optional<Estimate> estimate_translation(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                             const Eigen::Matrix3d& R,
                                             const TranslationOptions& options = {});

}  // namespace framewise
