// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "framewise/geometry/trajectory.h"
#include "framewise/simulation/path.h"

namespace framewise {

// A motion through given poses that is twice continuously differentiable in position and rotation. Velocity
// and acceleration at each pose are those of the quartic through it and its four neighbours (towards the ends
// the parabola of three poses), for rotations in the tangent space of the pose; between two poses quintics
// meet them, in R^3 and in the axis-angle vector phi of R_i^T R(t):
//   angular rate = Jr(phi) phi',   angular acceleration = Jr(phi) phi'' + (d Jr(phi) / dt) phi'
//   Solà, Deray, Atchuthan, A micro Lie theory for state estimation in robotics, 2018, Eq. (143).
class Se3Spline {
 public:
  // At least two poses, times increasing; successive rotations less than 180 degrees apart. Throws
  // std::invalid_argument that names what was found.
  explicit Se3Spline(const Trajectory& poses);

  double begin() const { return times_.front(); }
  double end() const { return times_.back(); }

  // Throws std::invalid_argument for a time before the first pose or after the last.
  Motion operator()(double time) const;

 private:
  // Quintics in s, 0 at its begin and 1 at its end: a column for each power.
  struct Segment {
    Eigen::Matrix3d R;  // at its begin
    Eigen::Matrix<double, 3, 6> position, turn;
  };

  std::vector<double> times_;
  std::vector<Segment> segments_;
};

}  // namespace framewise
