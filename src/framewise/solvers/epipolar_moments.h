// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

#include "framewise/geometry/pose.h"

namespace framewise {

// What any number of correspondences say about a rotation R and translation direction t through
//   sum w_i (t . n_i)^2 = t' M(R) t,  n_i = x2_i x R x1_i,
// summed once so that M(R) costs the same for 10 and for 10,000 points.
//   Kneip and Lynen, Direct optimization of frame-to-frame rotation, ICCV 2013, Eq. (6)-(11).
class EpipolarMoments {
 public:
  // Weights may be empty (all 1). Sizes agree.
  EpipolarMoments(std::span<const Bearing> x1, std::span<const Bearing> x2, std::span<const double> weights);

  struct Value {
    Eigen::Vector3d eigenvalues;   // of M(R), ascending
    Eigen::Matrix3d eigenvectors;  // columns; the first is the translation direction
  };
  // First and second derivatives of the smallest eigenvalue by a turn w, R = exp(w) R0.
  struct Derivatives {
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
  };

  Value evaluate(const Eigen::Matrix3d& R) const;
  Derivatives derivatives(const Eigen::Matrix3d& R, const Value& value) const;

  double total() const { return C_.trace(); }  // sum w_i for unit bearings

  // A vector that makes e' C e small, as the matrix of x2' E x1 = 0: the linear (8-point) solution.
  // `residual` is e' C e / e' e, which no rotation and direction can undercut by more than a half.
  Eigen::Matrix3d linear_solution(double& residual) const;

 private:
  using Vector9 = Eigen::Matrix<double, 9, 1>;
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  using Matrix93 = Eigen::Matrix<double, 9, 3>;
  Matrix9 C_;  // sum w v v', v = (x2 x1') row by row
};

}  // namespace framewise
