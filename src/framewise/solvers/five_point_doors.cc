// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/five_point_doors.h"

#include <Eigen/Geometry>

#include "framewise/geometry/so3.h"
#include "framewise/solvers/rotation_npt.h"

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

// Without parallax every [t]x R solves the equations. Of such a surface of solutions the elimination sees ten
// points, in one case of a hundred all of them complex; then the rotation that explains the bearings is the
// answer, with one of the directions that t may have.
std::optional<Pose> mere_rotation(const Bearings5& x1, const Bearings5& x2) {
  constexpr double kExact = 1e-10;
  const auto R = rotation_npt(x1, x2);
  if (!R) return std::nullopt;
  for (int i = 0; i < 5; ++i) {
    if (!((*R * x1[i]).cross(x2[i]).norm() < kExact)) return std::nullopt;
  }
  return Pose{*R, x2[0]};
}

template <typename Use>
void solve_each(Kernel* kernel, const Bearings5& x1, const Bearings5& x2, const Use& use) {
  Motion motions[10];
  const int count = kernel(to_points(x1, x2), motions);
  for (int i = 0; i < count; ++i) use(to_pose(motions[i]));
  if (count > 0) return;
  if (const auto rotation = mere_rotation(x1, x2)) use(*rotation);
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
  Hypotheses<Eigen::Matrix3d, 10> matrices;
  solve_each(kernel, x1, x2, [&](const Pose& pose) { matrices.push_back(skew(pose.t) * pose.R); });
  return matrices;
}

Hypotheses<Pose, 10> poses(Kernel* kernel, const Bearings5& x1, const Bearings5& x2) {
  Hypotheses<Pose, 10> poses;
  solve_each(kernel, x1, x2, [&](const Pose& pose) {
    // Half a turn about t gives the same E. Only without parallax may both see all points in front.
    const Pose twisted{(2 * pose.t) * (pose.t.transpose() * pose.R) - pose.R, pose.t};
    for (Pose candidate : {pose, twisted}) {
      if (poses.size() < poses.capacity() && choose_direction(x1, x2, candidate)) poses.push_back(candidate);
    }
  });
  return poses;
}

}  // namespace framewise::five_point
