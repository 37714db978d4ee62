// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_npt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::make_problem;
using testing::Random;
using testing::rotation_error;
using testing::Scene;

TEST(RotationNpt, ExactOnExactData) {
  Random random(1);
  for (const std::size_t n : {2, 3, 10, 100})
    for (int trial = 0; trial < 100; ++trial) {
      const auto p = make_problem(Scene::kPureRotation, n, random);
      const Eigen::Matrix3d Q = so3_exp(3 * random.direction());  // any rotation, not only small ones
      std::vector<Bearing> turned = p.x2;
      for (Bearing& x : turned) x = Q * x;
      const auto R = rotation_npt(p.x1, turned);
      ASSERT_TRUE(R);
      EXPECT_LT(rotation_error(*R, Q * p.cam2_from_cam1.R), n == 2 ? 1e-8 : 1e-11);
    }
}

TEST(RotationNpt, NoRotationNearbyFitsNoisyDataBetter) {
  Random random(2);
  const auto p = make_problem(Scene::kOdometry, 20, random);  // parallax is the noise
  std::vector<double> weights;
  for (int i = 0; i < 20; ++i) weights.push_back(random.uniform(0.1, 2));
  const auto cost = [&](const Eigen::Matrix3d& R) {
    double sum = 0;
    for (std::size_t i = 0; i < p.x1.size(); ++i) sum += weights[i] * (p.x2[i] - R * p.x1[i]).squaredNorm();
    return sum;
  };
  const auto R = rotation_npt(p.x1, p.x2, weights);
  ASSERT_TRUE(R);
  for (int trial = 0; trial < 50; ++trial) EXPECT_LT(cost(*R), cost(so3_exp(1e-3 * random.direction()) * *R));
}

TEST(RotationNpt, InvertsWhenSwapped) {
  Random random(3);
  const auto p = make_problem(Scene::kOdometry, 8, random);
  const auto R = rotation_npt(p.x1, p.x2), swapped = rotation_npt(p.x2, p.x1);
  ASSERT_TRUE(R && swapped);
  EXPECT_LT(rotation_error(*swapped, R->transpose()), 1e-13);
}

TEST(RotationNpt, IsEmptyWhereTheDataDoNotSuffice) {
  const std::vector<Bearing> same(5, Bearing::UnitZ());
  EXPECT_FALSE(rotation_npt(same, same));
  EXPECT_FALSE(rotation_npt({same.data(), 1}, {same.data(), 1}));
  EXPECT_FALSE(rotation_npt({}, {}));
  const std::vector<Bearing> x{Bearing::UnitX(), Bearing::Constant(NAN), Bearing::UnitZ()};
  EXPECT_FALSE(rotation_npt(x, x));
}

TEST(RotationNpt, RefusesSizesThatDiffer) {
  const std::vector<Bearing> x(5, Bearing::UnitZ());
  const std::vector<double> weights(4, 1.0);
  EXPECT_THROW(rotation_npt(x, {x.data(), 4}), std::invalid_argument);
  EXPECT_THROW(rotation_npt(x, x, weights), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
