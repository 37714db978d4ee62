// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/fundamental_7pt.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/null_space.h"

namespace framewise {
namespace {

// det(s A + B) = c[3] s^3 + c[2] s^2 + c[1] s + c[0].
std::array<double, 4> determinant_cubic(const Eigen::Matrix3d& A, const Eigen::Matrix3d& B) {
  const auto a0 = A.col(0), a1 = A.col(1), a2 = A.col(2), b0 = B.col(0), b1 = B.col(1), b2 = B.col(2);
  const Eigen::Vector3d a12 = a1.cross(a2), b12 = b1.cross(b2), mixed = a1.cross(b2) + b1.cross(a2);
  return {b0.dot(b12), a0.dot(b12) + b0.dot(mixed), b0.dot(a12) + a0.dot(mixed), a0.dot(a12)};
}

// Real roots of s^3 + a s^2 + b s + c, one or three (a double root counts twice).
Hypotheses<double, 3> real_roots(double a, double b, double c) {
  const double Q = (a * a - 3 * b) / 9, R = (a * (2 * a * a - 9 * b) + 27 * c) / 54;
  const double Q3 = Q * Q * Q, R2 = R * R;
  Hypotheses<double, 3> roots;
  // A double root that rounding has parted is still two.
  if (R2 <= Q3 * (1 + 1e-13) && Q > 0) {
    const double ratio = std::clamp(R / std::sqrt(Q3), -1.0, 1.0), theta = std::acos(ratio) / 3;
    for (int k = -1; k <= 1; ++k)
      roots.push_back(-2 * std::sqrt(Q) * std::cos(theta + k * (2 * M_PI / 3)) - a / 3);
  } else {
    const double A = -std::copysign(std::cbrt(std::abs(R) + std::sqrt(std::max(R2 - Q3, 0.0))), R);
    roots.push_back(A + (A != 0 ? Q / A : 0) - a / 3);
  }
  for (double& s : roots) {
    for (int step = 0; step < 2; ++step) {
      const double slope = (3 * s + 2 * a) * s + b, change = (((s + a) * s + b) * s + c) / slope;
      if (std::abs(change) < 1e-3 * (1 + std::abs(s))) s -= change;
    }
  }
  return roots;
}

}  // namespace

Hypotheses<Eigen::Matrix3d, 3> fundamental_7pt(const std::array<Eigen::Vector3d, 7>& x1,
                                               const std::array<Eigen::Vector3d, 7>& x2) {
  Eigen::Matrix<double, 9, 7> rows;
  for (int i = 0; i < 7; ++i) rows.col(i) = epipolar_row(x1[i], x2[i]);
  const Eigen::Matrix<double, 9, 2> basis = null_space<7>(rows);
  Eigen::Matrix3d A = Eigen::Map<const Eigen::Matrix3d>(basis.col(0).data());
  Eigen::Matrix3d B = Eigen::Map<const Eigen::Matrix3d>(basis.col(1).data());
  std::array<double, 4> c = determinant_cubic(A, B);
  // Roots at infinity are avoided by the choice of A among A, B and A + B.
  if (std::abs(c[0]) > std::abs(c[3])) {
    std::swap(A, B);
    std::swap(c[0], c[3]);
    std::swap(c[1], c[2]);
  }
  const double largest = std::max(std::abs(c[1]), std::abs(c[2]));
  if (std::abs(c[3]) < 1e-3 * largest) {
    const Eigen::Matrix3d sum = M_SQRT1_2 * (A + B), difference = M_SQRT1_2 * (A - B);
    A = sum;
    B = difference;
    c = determinant_cubic(A, B);
  }
  Hypotheses<Eigen::Matrix3d, 3> solutions;
  for (const double s : real_roots(c[2] / c[3], c[1] / c[3], c[0] / c[3])) {
    // A and B are orthonormal. Every matrix of the space has rank 2 where the cubic is zero: then s is not
    // finite.
    const Eigen::Matrix3d F = (s * A + B) / std::sqrt(s * s + 1);
    if (F.allFinite()) solutions.push_back(F);
  }
  return solutions;
}

Hypotheses<Pose, 3> relpose_7pt(const std::array<Bearing, 7>& x1, const std::array<Bearing, 7>& x2) {
  Hypotheses<Pose, 3> poses;
  for (const Eigen::Matrix3d& F : fundamental_7pt(x1, x2)) {
    const auto vote = choose_by_cheirality(F, x1, x2);
    if (vote && vote->in_front >= 4) poses.push_back(vote->cam2_from_cam1);
  }
  return poses;
}

}  // namespace framewise
