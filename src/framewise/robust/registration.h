// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

struct RegistrationOptions {
  RansacOptions ransac;
  double max_error = 0.05;  // |R X1 + t - X2| of an inlier (m)
  int min_inliers = 4;      // fewer are no answer; three points fit any three
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// Motion between two clouds of corresponding points, some of them wrong: x2 = R x1 + t.
// Kabsch/Arun of three points in RANSAC, then of all inliers until they no longer change.
// Empty: fewer than 3 points, or too few inliers. Throws std::invalid_argument on sizes that differ and on
// numbers that are not finite.
std::optional<Estimate> estimate_registration(std::span<const Eigen::Vector3d> X1,
                                              std::span<const Eigen::Vector3d> X2,
                                              const RegistrationOptions& options = {});

}  // namespace framewise
