// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

enum class RelativePoseSolver {
  kEightPoint,
  kSevenPoint,
  kNister5pt,
  kStewenius5pt,
  kKneip5ptRotation,
  kEigensolver,
  kTwoPoint  // rotation known
};

struct RelativePoseOptions {
  RansacOptions ransac;
  RelativePoseSolver solver = RelativePoseSolver::kEightPoint;
  // Distance to the epipolar geometry of an inlier, as an angle (rad): pixels / focal length.
  double max_error = 2.0 / 525;
  int min_inliers = 12;  // fewer are no answer
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// Motion between two calibrated views from corresponding bearings, some of them wrong:
//   lambda2 x2 = R (lambda1 x1) + t,  |t| = 1.
// Empty: fewer points than the solver needs, or too few inliers. Throws std::invalid_argument on sizes that
// differ, on numbers that are not finite and on bearings of length zero.
std::optional<Estimate> estimate_relative_pose(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                               const RelativePoseOptions& options = {});

}  // namespace framewise
