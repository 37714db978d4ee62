// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "framewise/evaluation/association.h"
#include "framewise/evaluation/statistics.h"

namespace framewise {

// Deviation of the estimate from the reference axis by axis, where an error has a direction: a drift along
// one axis, or one angle that is wrong, shows here and not in a distance.
struct AxisErrors {
  std::array<Statistics, 3> position;   // |x|, |y|, |z| of the difference in the reference's world (m)
  std::array<Statistics, 3> euler_deg;  // |difference| of the Euler angles about x, y, z; R = Rz Ry Rx
  Eigen::Vector3d cumulative = Eigen::Vector3d::Zero();  // sum over all poses of |x|, |y|, |z| (m)
};

// Of trajectories that are matched and aligned. Throws std::invalid_argument where there is no pose.
AxisErrors axis_errors(const TrajectoryPair& aligned);

// The cumulative deviation up to each pose: row i sums poses 0 to i (m).
Eigen::Matrix<double, Eigen::Dynamic, 3> cumulative_deviation(const TrajectoryPair& aligned);

}  // namespace framewise
