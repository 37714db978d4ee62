// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/axis_errors.h"

#include <cmath>
#include <vector>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

Eigen::Vector3d deviation(const TrajectoryPair& aligned, std::size_t i) {
  return (aligned.estimate.world_from_cam[i].t - aligned.reference.world_from_cam[i].t).cwiseAbs();
}

// Angles that differ by a full turn are the same.
Eigen::Vector3d euler_difference(const TrajectoryPair& aligned, std::size_t i) {
  const Eigen::Vector3d difference =
      euler_zyx(aligned.estimate.world_from_cam[i].R) - euler_zyx(aligned.reference.world_from_cam[i].R);
  return difference.unaryExpr([](double angle) { return std::abs(std::remainder(angle, 2 * M_PI)); });
}

}  // namespace

AxisErrors axis_errors(const TrajectoryPair& aligned) {
  AxisErrors errors;
  std::array<std::vector<double>, 3> positions, angles;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    const Eigen::Vector3d position = deviation(aligned, i), angle = euler_difference(aligned, i);
    for (int axis = 0; axis < 3; ++axis) {
      positions[axis].push_back(position[axis]);
      angles[axis].push_back(angle[axis] * 180 / M_PI);
    }
    errors.cumulative += position;
  }
  for (int axis = 0; axis < 3; ++axis) {
    errors.position[axis] = statistics(positions[axis]);
    errors.euler_deg[axis] = statistics(angles[axis]);
  }
  return errors;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> cumulative_deviation(const TrajectoryPair& aligned) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> sums(aligned.size(), 3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    sum += deviation(aligned, i);
    sums.row(static_cast<Eigen::Index>(i)) = sum;
  }
  return sums;
}

}  // namespace framewise
