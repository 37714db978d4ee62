// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/pose.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

TEST(So3, LogInvertsExpFromIdentityToPi) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 0.5).normalized();
  for (const double angle : {0.0, 1e-12, 1e-8, 1e-4, 0.1, 1.0, 3.0, M_PI - 1e-9}) {
    const Eigen::Vector3d phi = angle * axis;
    EXPECT_LT((so3_log(so3_exp(phi)) - phi).norm(), 1e-14 + 1e-9 * (angle > 3.1)) << angle;
    EXPECT_NEAR(rotation_angle(so3_exp(phi)), angle, 1e-14 + 1e-9 * (angle > 3.1));
  }
}

TEST(So3, RightJacobianIsTheDerivativeOfExp) {
  for (const double scale : {0.0, 1e-8, 1e-3, 1.0, 2.5}) {
    const Eigen::Vector3d phi = scale * Eigen::Vector3d(0.3, -0.5, 0.8);
    Eigen::Matrix3d numeric;
    const double h = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d d = h * Eigen::Vector3d::Unit(k);
      numeric.col(k) = (so3_log(so3_exp(phi).transpose() * so3_exp(phi + d)) -
                        so3_log(so3_exp(phi).transpose() * so3_exp(phi - d))) /
                       (2 * h);
    }
    EXPECT_LT((so3_right_jacobian(phi) - numeric).norm(), 1e-8) << scale;
  }
}

TEST(So3, RotationBetweenTakesOneDirectionToTheOther) {
  const Eigen::Vector3d a = Eigen::Vector3d(0.3, -0.5, 0.8).normalized(), across = a.unitOrthogonal();
  for (const double angle : {0.0, 1e-12, 1e-6, 0.4, 2.0, M_PI - 1e-6, M_PI - 1e-12, M_PI}) {
    const Eigen::Vector3d b = std::cos(angle) * a + std::sin(angle) * across;
    const Eigen::Matrix3d R = rotation_between(a, b);
    EXPECT_LT((R * a - b).norm(), 1e-14) << angle;
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14) << angle;
    EXPECT_NEAR(R.determinant(), 1, 1e-14) << angle;
    EXPECT_NEAR(rotation_angle(R), angle, 1e-14) << angle;
  }
}

// Eigenvalues 1, 2, 3, ... in axes of no special kind.
template <int N>
Eigen::Matrix<double, N, N> with_known_eigenvalues() {
  using Matrix = Eigen::Matrix<double, N, N>;
  const Eigen::Matrix<double, N, 1> v = Eigen::Matrix<double, N, 1>::LinSpaced(1, 2).normalized();
  const Matrix Q = Matrix::Identity() - 2 * v * v.transpose();
  return Q * Eigen::Matrix<double, N, 1>::LinSpaced(1, N).asDiagonal() * Q;
}

template <int N>
void expect_eigenvalues() {
  const Eigen::Matrix<double, N, N> S = with_known_eigenvalues<N>();
  const SymmetricEigen<N> eigen = symmetric_eigen(S);
  EXPECT_LT((eigen.values - Eigen::Matrix<double, N, 1>::LinSpaced(1, N)).norm(), 1e-13);
  EXPECT_LT((S * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-13);
}

TEST(LinearAlgebra, EigenvaluesIncrease) {
  expect_eigenvalues<3>();
  expect_eigenvalues<9>();
}

template <int N>
void expect_cholesky() {
  const Eigen::Matrix<double, N, N> S = with_known_eigenvalues<N>(),
                                    I = Eigen::Matrix<double, N, N>::Identity();
  const Cholesky<N> cholesky(S);
  ASSERT_TRUE(cholesky.positive_definite());
  const Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::LinSpaced(-1, 3);
  EXPECT_LT((S * cholesky.solve(b) - b).norm(), 1e-13);
  EXPECT_LT((S * cholesky.inverse() - I).norm(), 1e-13);
  EXPECT_LT((cholesky.inverse_of_factor() * S * cholesky.inverse_of_factor().transpose() - I).norm(), 1e-13);
  EXPECT_FALSE(Cholesky<N>(S - 2 * I).positive_definite());
}

TEST(LinearAlgebra, CholeskySolvesAndInvertsAndTellsIndefiniteMatrices) {
  expect_cholesky<3>();
  expect_cholesky<5>();
  expect_cholesky<6>();
  expect_cholesky<9>();
}

TEST(Pose, ProductsAndInversesAct) {
  const Pose b_from_a{so3_exp({0.1, 0.2, -0.3}), {1, 2, 3}}, c_from_b{so3_exp({-1, 0.5, 2}), {-4, 0, 2}};
  const Eigen::Vector3d x_in_a(0.3, -0.7, 2);
  EXPECT_LT(((c_from_b * b_from_a) * x_in_a - c_from_b * (b_from_a * x_in_a)).norm(), 1e-14);
  EXPECT_LT((b_from_a.inverse() * (b_from_a * x_in_a) - x_in_a).norm(), 1e-14);
}

TEST(Pose, InterpolationHitsBothEndsAndTurnsEvenly) {
  const Pose a{so3_exp({0.1, 0.2, -0.3}), {1, 2, 3}}, b{so3_exp({-1, 0.5, 2}), {-4, 0, 2}};
  EXPECT_LT((interpolate(a, b, 0).matrix() - a.matrix()).norm(), 1e-14);
  EXPECT_LT((interpolate(a, b, 1).matrix() - b.matrix()).norm(), 1e-14);
  const double whole = rotation_angle(a.R.transpose() * b.R);
  EXPECT_NEAR(rotation_angle(a.R.transpose() * interpolate(a, b, 0.25).R), 0.25 * whole, 1e-14);
}

TEST(So3, EulerAnglesMakeTheRotationAgain) {
  for (const Eigen::Vector3d& angles : {Eigen::Vector3d(0.3, -1.2, 2.9), Eigen::Vector3d(-3.0, 1.5, -0.1)}) {
    const Eigen::Vector3d x(angles.x(), 0, 0), y(0, angles.y(), 0), z(0, 0, angles.z());
    EXPECT_LT((euler_zyx(so3_exp(z) * so3_exp(y) * so3_exp(x)) - angles).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace framewise
