// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_2pt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

TEST(Rotation2pt, ExactOnExactDataHoweverCloseTheBearings) {
  Random random(1);
  for (const double spread : {3.0, 1.0, 1e-2, 1e-6})
    for (int trial = 0; trial < 200; ++trial) {
      const Bearing a = random.direction();
      const Bearing b = (a + spread * random.direction()).normalized();
      const Eigen::Matrix3d R = so3_exp(M_PI * random.direction() * random.uniform(0, 1));
      const auto found = rotation_2pt({a, b}, {R * a, R * b});
      ASSERT_TRUE(found);
      const double sine = a.cross(b).norm();
      EXPECT_LT(rotation_error(*found, R), 1e-15 + 4e-15 / sine);
      EXPECT_LT((*found * found->transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      EXPECT_GT(found->determinant(), 0);
    }
}

TEST(Rotation2pt, NoRotationNearbyFitsDisagreeingAnglesBetter) {
  Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const std::array<Bearing, 2> x1{random.direction(), random.direction()};
    const std::array<Bearing, 2> x2{random.direction(), random.direction()};
    const auto cost = [&](const Eigen::Matrix3d& R) {
      return (x2[0] - R * x1[0]).squaredNorm() + (x2[1] - R * x1[1]).squaredNorm();
    };
    const auto R = rotation_2pt(x1, x2);
    ASSERT_TRUE(R);
    for (int k = 0; k < 20; ++k) EXPECT_LE(cost(*R), cost(so3_exp(1e-3 * random.direction()) * *R) + 1e-12);
  }
}

TEST(Rotation2pt, TurnsWithTheCamerasAndInvertsWhenSwapped) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto p = make_problem(Scene::kRandom, 2, random);  // with a baseline: the angles differ
    const Eigen::Matrix3d Q1 = so3_exp(2 * random.direction()), Q2 = so3_exp(2 * random.direction());
    const auto R = rotation_2pt({p.x1[0], p.x1[1]}, {p.x2[0], p.x2[1]});
    const auto turned = rotation_2pt({Q1 * p.x1[0], Q1 * p.x1[1]}, {Q2 * p.x2[0], Q2 * p.x2[1]});
    const auto swapped = rotation_2pt({p.x2[0], p.x2[1]}, {p.x1[0], p.x1[1]});
    ASSERT_TRUE(R && turned && swapped);
    EXPECT_LT(rotation_error(*turned, Q2 * *R * Q1.transpose()), 1e-12);
    EXPECT_LT(rotation_error(*swapped, R->transpose()), 1e-12);
  }
}

TEST(Rotation2pt, IsEmptyOnParallelBearingsAndNaN) {
  const Bearing x = Bearing::UnitX(), z = Bearing::UnitZ();
  EXPECT_FALSE(rotation_2pt({x, x}, {x, z}));
  EXPECT_FALSE(rotation_2pt({x, z}, {z, z}));
  EXPECT_FALSE(rotation_2pt({x, -x}, {x, z}));
  EXPECT_FALSE(rotation_2pt({x, Bearing::Constant(NAN)}, {x, z}));
}

}  // namespace
}  // namespace framewise
