// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/pose.h"
#include "framewise/geometry/so3.h"
#include "framewise/solvers/refine_kernels.h"
#include "framewise/solvers/refinement.h"

// The one loop behind every refinement: fixed sizes, no heap.
//   Madsen, Nielsen, Tingleff, Methods for Non-Linear Least Squares Problems, 2004.
namespace framewise {

// Rotation and translation: 6 degrees of freedom, the pose's own tangent.
struct RigidMotion {
  static constexpr int kDof = 6;
  using Basis = Eigen::Matrix<double, 6, 6>;
  using Step = Eigen::Matrix<double, 6, 1>;
  static Pose move(const Pose& pose, const Step& d) {
    return {pose.R * so3_exp(d.head<3>()), pose.t + d.tail<3>()};
  }
  static Eigen::Matrix3d translations(const Pose&) { return Eigen::Matrix3d::Identity(); }
};

// Rotation and direction of translation, |t| = 1: 5 degrees of freedom, the last two along sphere_tangent(t).
struct MotionUpToScale {
  static constexpr int kDof = 5;
  using Basis = Eigen::Matrix<double, 6, 5>;
  using Step = Eigen::Matrix<double, 5, 1>;
  static Pose move(const Pose& pose, const Step& d) {
    return {pose.R * so3_exp(d.head<3>()), sphere_exp(pose.t, d.tail<2>())};
  }
  static Eigen::Matrix<double, 3, 2> translations(const Pose& pose) { return sphere_tangent(pose.t); }
};

inline KernelPose kernel_pose(const Pose& pose) {
  KernelPose k;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(k.R) = pose.R;
  Eigen::Map<Eigen::Vector3d>(k.t) = pose.t;
  return k;
}

// cost(pose + d) = cost + 2 g' d + d' H d
template <typename Motion>
struct NormalEquations {
  Eigen::Matrix<double, Motion::kDof, Motion::kDof> H;
  typename Motion::Step g;
};

// The kernels turn in camera 2's axes, W = R w; poses turn by w.
template <typename Motion>
NormalEquations<Motion> normal_equations(const NormalSums& sums, const Pose& pose) {
  Matrix6d H;
  for (int row = 0, n = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column, ++n) H(row, column) = H(column, row) = sums.H[n];
  typename Motion::Basis basis = Motion::Basis::Zero();
  basis.template topLeftCorner<3, 3>() = pose.R;
  basis.template bottomRightCorner<3, Motion::kDof - 3>() = Motion::translations(pose);
  return {basis.transpose() * H * basis, basis.transpose() * Eigen::Map<const Vector6d>(sums.g)};
}

// The inverse of H, or NaN where H is singular to rounding.
template <int kDof>
Eigen::Matrix<double, kDof, kDof> inverse_information(const Eigen::Matrix<double, kDof, kDof>& H) {
  using Matrix = Eigen::Matrix<double, kDof, kDof>;
  const Eigen::Matrix<double, kDof, 1> scale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Cholesky<kDof> cholesky(scale.asDiagonal() * H * scale.asDiagonal());
  // Each entry is the share of a coordinate's information that the others do not explain.
  if (!cholesky.positive_definite() || !(cholesky.L().diagonal().minCoeff() > 1e-7))
    return Matrix::Constant(std::numeric_limits<double>::quiet_NaN());
  return scale.asDiagonal() * cholesky.inverse() * scale.asDiagonal();
}

template <typename Motion>
Matrix6d pose_covariance(const NormalEquations<Motion>& normal, const Pose& pose) {
  typename Motion::Basis basis = Motion::Basis::Zero();
  basis.template topLeftCorner<3, 3>().setIdentity();
  basis.template bottomRightCorner<3, Motion::kDof - 3>() = Motion::translations(pose);
  const Matrix6d covariance = basis * inverse_information<Motion::kDof>(normal.H) * basis.transpose();
  return 0.5 * (covariance + covariance.transpose());
}

// sums_at(pose): NormalSums at a pose.
template <typename Motion, typename SumsAt>
Refinement minimise(const Pose& initial, const SumsAt& sums_at, const RefineOptions& options) {
  Refinement result;
  result.pose = initial;
  NormalSums sums = sums_at(initial);
  double damping = 1e-6, expected_decrease = 0;
  while (result.iterations < options.max_iterations && damping < 1e8) {
    ++result.iterations;
    const NormalEquations<Motion> normal = normal_equations<Motion>(sums, result.pose);
    auto damped = normal.H;
    damped.diagonal() *= 1 + damping;
    const Cholesky<Motion::kDof> cholesky(damped);
    const typename Motion::Step step = cholesky.solve(-normal.g);
    expected_decrease = -normal.g.dot(step);
    if (!cholesky.positive_definite() || !(expected_decrease >= 0)) {
      damping = std::max(1e-3, 10 * damping);
      continue;
    }
    const Pose next = Motion::move(result.pose, step);
    if (expected_decrease < options.tolerance) {
      // So near that another look at the points would change nothing.
      result.pose = next;
      result.converged = true;
      break;
    }
    const NormalSums next_sums = sums_at(next);
    if (next_sums.cost < sums.cost) {
      result.pose = next;
      sums = next_sums;
      damping = std::max(1e-12, 0.1 * damping);
    } else {
      damping = std::max(1e-3, 10 * damping);
    }
  }
  result.cost = sums.cost;
  result.covariance = pose_covariance(normal_equations<Motion>(sums, result.pose), result.pose);
  return result;
}

}  // namespace framewise
