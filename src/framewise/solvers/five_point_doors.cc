// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/five_point_doors.h"

#include <Eigen/Geometry>

#include "framewise/geometry/so3.h"

namespace framewise::five_point {
namespace {

Points to_points(const Bearings5& x1, const Bearings5& x2) {
  Points points;
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 3; ++k) {
      points.x1[i][k] = x1[i][k];
      points.x2[i][k] = x2[i][k];
    }
  }
  return points;
}

Pose to_pose(const Motion& motion) {
  return {Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&motion.R[0][0]),
          Eigen::Map<const Eigen::Vector3d>(motion.t)};
}

// True where all points are in front for (R, t) or for (R, -t); then t is the right one.
bool choose_direction(const Bearings5& x1, const Bearings5& x2, Pose& pose) {
  constexpr double kRounding = 1e-15;
  double sign = 0;
  for (int i = 0; i < 5; ++i) {
    // lambda2 x2 = lambda1 R x1 + t, crossed with x2 and with R x1.
    const Eigen::Vector3d Rx1 = pose.R * x1[i], n = Rx1.cross(x2[i]), tn = pose.t.cross(n);
    const double lambda1 = x2[i].dot(tn), lambda2 = Rx1.dot(tn);
    if (sign == 0) sign = lambda1 + lambda2 < 0 ? -1 : 1;
    if (sign * lambda1 < -kRounding || sign * lambda2 < -kRounding) return false;
  }
  pose.t *= sign;
  return true;
}

}  // namespace

Hypotheses<Eigen::Matrix3d, 10> essential_matrices(Kernel* kernel, const Bearings5& x1, const Bearings5& x2) {
  Motion motions[10];
  const int count = kernel(to_points(x1, x2), motions);
  Hypotheses<Eigen::Matrix3d, 10> matrices;
  for (int i = 0; i < count; ++i) {
    const Pose pose = to_pose(motions[i]);
    matrices.push_back(skew(pose.t) * pose.R);
  }
  return matrices;
}

Hypotheses<Pose, 10> poses(Kernel* kernel, const Bearings5& x1, const Bearings5& x2) {
  Motion motions[10];
  const int count = kernel(to_points(x1, x2), motions);
  Hypotheses<Pose, 10> poses;
  for (int i = 0; i < count; ++i) {
    const Pose pose = to_pose(motions[i]);
    // Half a turn about t gives the same E. Only without parallax may both see all points in front.
    const Pose twisted{(2 * pose.t) * (pose.t.transpose() * pose.R) - pose.R, pose.t};
    for (Pose candidate : {pose, twisted}) {
      if (poses.size() < poses.capacity() && choose_direction(x1, x2, candidate)) poses.push_back(candidate);
    }
  }
  return poses;
}

}  // namespace framewise::five_point
