// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/residual_noise.h"

#include <gtest/gtest.h>

#include "framewise/solvers/problems_for_tests.h"

namespace framewise {
namespace {

using testing::Random;

// Over a view of 60 degrees, at 2 m; residuals of `sigmas` times what is said, alike in blocks of the view.
std::vector<PlacedBy> points_with(double sigmas, bool alike, std::uint64_t seed) {
  Random random(seed);
  std::vector<PlacedBy> points;
  for (int block = 0; block < 40; ++block) {
    const double x = 0.125 * (block % 8 - 4) + 0.06, y = 0.125 * (block / 8 - 2) + 0.06;
    const Eigen::Vector2d shared(random.normal(), random.normal());
    const double shared_z = random.normal();
    for (int i = 0; i < 10; ++i) {
      const Eigen::Vector2d own(random.normal(), random.normal());
      const double own_z = random.normal();
      points.push_back({{0, static_cast<int>(points.size())},
                        {2 * x, 2 * y, 2},
                        Eigen::Matrix3d::Zero(),
                        0.001 * sigmas * (alike ? shared : own),
                        {0.001},
                        0.01 * sigmas * (alike ? shared_z : own_z),
                        0.01});
    }
  }
  return points;
}

TEST(LikenessOfNeighbours, IsOneOfIndependentNoiseAndTheirNumberWhereAllAreTheSame) {
  const Likeness none = likeness_of_neighbours(points_with(1, false, 1));
  EXPECT_NEAR(none.ray, 1, 0.3);
  EXPECT_NEAR(none.z, 1, 0.4);
  const Likeness all = likeness_of_neighbours(points_with(1, true, 1));
  EXPECT_NEAR(all.ray, 10, 1e-6);
  EXPECT_NEAR(all.z, 10, 1e-6);
  EXPECT_EQ(likeness_of_neighbours({}).ray, 1);
}

TEST(ResidualTails, AreTheSquareOfNoiseOverWhatIsSaid) {
  const ResidualTails tails = residual_tails(points_with(1.5, false, 2));
  EXPECT_NEAR(tails.ray, 2.25, 0.25);
  EXPECT_NEAR(tails.z, 2.25, 0.4);
  EXPECT_EQ(residual_tails({}).ray, 1);
  EXPECT_EQ(residual_tails({}).z, 1);
}

TEST(MeasuredByPosition, IsTheDerivativeOfRayAndDepth) {
  PlacedBy point = points_with(1, false, 3)[7];
  point.x_in_cam = {0.4, -0.3, 1.7};
  const auto measured = [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return {x.x() / x.z(), x.y() / x.z(), x.z()};
  };
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const Eigen::Vector3d slope =
        (measured(point.x_in_cam + step) - measured(point.x_in_cam - step)) / (2 * kStep);
    EXPECT_LT((measured_by_position(point).col(i) - slope).norm(), 1e-8);
  }
  point.z_sigma = 0;
  EXPECT_EQ(measured_by_position(point).row(2).norm(), 0);
}

}  // namespace
}  // namespace framewise
