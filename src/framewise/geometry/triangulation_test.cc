// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/triangulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr ImageSurface kSurfaces[] = {ImageSurface::kPlane, ImageSurface::kSphere};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (engine_() >> 11) * 0x1.0p-53; }
  Eigen::Vector3d box() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  Pose pose() { return {so3_exp(0.4 * box()), box()}; }
  Eigen::Vector3d point() {
    const double depth = uniform(2, 8);
    return {depth * uniform(-0.6, 0.6), depth * uniform(-0.4, 0.4), depth};
  }

 private:
  std::mt19937_64 engine_;
};

Eigen::Vector3d on_surface(const Eigen::Vector3d& x, ImageSurface surface) {
  return x / (surface == ImageSurface::kPlane ? x.z() : x.norm());
}

TEST(Triangulation, ExactRaysMeetAtThePoint) {
  Draw draw(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose pose = draw.pose();
    const Eigen::Vector3d X1 = draw.point(), X2 = pose * X1;
    for (const auto& found : {triangulate_midpoint(pose, 3 * X1, X2), triangulate_optimal(pose, X1, X2),
                              triangulate_optimal(pose, X1, X2, ImageSurface::kPlane)}) {
      ASSERT_TRUE(found);
      EXPECT_LT((found->X1 - X1).norm(), 1e-10 / found->parallax / found->parallax * 1e-2 + 1e-11);
      EXPECT_NEAR(found->lambda1, X1.norm(), 1e-9);
      EXPECT_NEAR(found->lambda2, X2.norm(), 1e-9);
      EXPECT_NEAR(found->parallax, parallax(pose.R, X1, X2), 1e-12);
      EXPECT_TRUE(found->in_front());
    }
  }
}

TEST(Triangulation, APointBehindACameraHasANegativeDepth) {
  const Pose pose{Eigen::Matrix3d::Identity(), {1, 0, 0}};
  const Eigen::Vector3d X1(0.3, 0.2, 4), X2 = pose * X1;
  EXPECT_LT(triangulate_midpoint(pose, -X1, X2)->lambda1, 0);
  EXPECT_LT(triangulate_midpoint(pose, X1, -X2)->lambda2, 0);
  EXPECT_FALSE(triangulate_midpoint(pose, -X1, X2)->in_front());
  // Rays that diverge meet behind both.
  EXPECT_FALSE(triangulate_midpoint(pose, X2, X1)->in_front());
}

TEST(Triangulation, ParallelRaysAndNoBaselineAreNoAnswer) {
  const Pose pose{Eigen::Matrix3d::Identity(), {1, 0, 0}};
  const Eigen::Vector3d x(0.1, 0.2, 1);
  EXPECT_FALSE(triangulate_midpoint(pose, x, x));
  EXPECT_FALSE(triangulate_optimal({pose.R, {0, 0, 0}}, x, Eigen::Vector3d(0, 0, 1)));
}

TEST(Triangulation, CorrectedRaysMeetAndCostIsTheirDistance) {
  Draw draw(2);
  for (const ImageSurface surface : kSurfaces)
    for (int trial = 0; trial < 200; ++trial) {
      const Pose pose = draw.pose();
      const Eigen::Vector3d X1 = draw.point();
      const Eigen::Vector3d x1 = on_surface(X1 + 0.05 * draw.box(), surface);
      const Eigen::Vector3d x2 = on_surface(pose * X1 + 0.05 * draw.box(), surface);
      const MeetingRays rays = nearest_meeting_rays(pose, x1, x2, surface);
      EXPECT_NEAR(algebraic_residual(pose, rays.x1, rays.x2), 0, 1e-14);
      const double moved = surface == ImageSurface::kPlane
                               ? (rays.x1 - x1).squaredNorm() + (rays.x2 - x2).squaredNorm()
                               : rays.x1.cross(x1).squaredNorm() + rays.x2.cross(x2).squaredNorm();
      EXPECT_NEAR(moved, rays.cost, 1e-14);
      const double first_order = sampson_residual(pose, x1, x2, surface);
      EXPECT_NEAR(std::sqrt(rays.cost), std::abs(first_order), 0.3 * std::abs(first_order));
    }
}

// No other epipolar plane comes closer: planes turned about t by a little, the rays moved into each the
// shortest way.
TEST(Triangulation, NoOtherEpipolarPlaneIsNearer) {
  Draw draw(3);
  for (const ImageSurface surface : kSurfaces)
    for (int trial = 0; trial < 200; ++trial) {
      const Pose pose = draw.pose();
      const Eigen::Vector3d X1 = draw.point();
      const Eigen::Vector3d x1 = on_surface(X1 + 0.05 * draw.box(), surface);
      const Eigen::Vector3d x2 = on_surface(pose * X1 + 0.05 * draw.box(), surface);
      const MeetingRays rays = nearest_meeting_rays(pose, x1, x2, surface);
      const auto distance2 = [&](const Eigen::Vector3d& n, const Eigen::Vector3d& x) {
        const double off = n.dot(x);
        return surface == ImageSurface::kPlane ? off * off / n.head<2>().squaredNorm() : off * off;
      };
      const Eigen::Vector3d n = pose.t.cross(rays.x2).normalized();
      for (const double turn : {-1e-3, -1e-5, 0.0, 1e-5, 1e-3}) {
        const Eigen::Vector3d other = so3_exp(turn * pose.t.normalized()) * n;
        const double cost = distance2(pose.R.transpose() * other, x1) + distance2(other, x2);
        if (turn == 0)
          EXPECT_NEAR(cost, rays.cost, 1e-13);
        else
          EXPECT_GE(cost, rays.cost * (1 - 1e-9));
      }
    }
}

}  // namespace
}  // namespace framewise
