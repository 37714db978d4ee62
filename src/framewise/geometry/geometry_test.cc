// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace framewise
