// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "framewise/geometry/pose.h"

namespace framewise {

// What the data support.
enum class EstimateKind {
  kFull,          // rotation and translation
  kRotationOnly,  // rotation; the translation is not told from zero by these data
  kLowParallax    // rotation; there is a translation, but its direction is poorly known
};

// One motion from many correspondences, some of them wrong.
struct Estimate {
  Pose cam2_from_cam1;                // t in metres, or |t| = 1 where only bearings were given
  std::vector<std::uint8_t> inliers;  // 1 for each correspondence that agrees
  std::size_t num_inliers = 0;
  double score = 0;              // sum of the prices of all correspondences (Scoring): lower is better
  int iterations = 0;            // hypotheses tried
  double iterations_theory = 0;  // log(1-p) / log(1-w^s) at the final share of inliers
  // Of the tangent vector (rotation, translation); NaN where it is not known.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  EstimateKind kind = EstimateKind::kFull;
};

}  // namespace framewise
