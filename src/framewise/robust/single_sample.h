// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {

// What a solver makes of one sample, no correspondence rejected: RANSAC switched off as laboratories do it
// (one hypothesis, a threshold that nothing exceeds), to show what RANSAC is for.
//   The sample is drawn with options.ransac.seed. Of several solutions the one that fits the sample and three
// more correspondences best is taken, by the sum of squares of options.measure; the thresholds are not used.
// Every correspondence is an inlier; kind is kFull and there is no covariance, for nothing was checked.
// Empty: fewer points than the solver needs, or no solution. Throws as estimate_relative_pose does.
std::optional<Estimate> estimate_relative_pose_from_one_sample(std::span<const Bearing> x1,
                                                               std::span<const Bearing> x2,
                                                               const RelativePoseOptions& options = {});

// The same for points: Kabsch/Arun of three (registration.h).
std::optional<Estimate> estimate_registration_from_one_sample(std::span<const Eigen::Vector3d> X1,
                                                              std::span<const Eigen::Vector3d> X2,
                                                              std::uint64_t seed);

}  // namespace framewise
