// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_kernels.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "framewise/geometry/depth_noise.h"
#include "framewise/geometry/triangulation.h"
#include "framewise/solvers/levenberg_marquardt.h"
#include "framewise/solvers/refine_input.h"
#include "framewise/solvers/refine_registration.h"
#include "framewise/solvers/refine_rgbd_pair.h"
#include "framewise/solvers/refinement_for_tests.h"

namespace framewise {
namespace {

using testing::Random;
using Kernel = std::function<NormalSums(const Pose&, const RobustLoss&)>;

constexpr double kSigma = 0.002;
constexpr Loss kLosses[] = {Loss::kTrivial, Loss::kHuber, Loss::kCauchy, Loss::kTruncated, Loss::kTukey};

// Every kernel on one noisy scene, all with something to complain about.
struct Fixture {
  explicit Fixture(std::size_t size, std::uint64_t seed = 1) : random(seed) {
    problem = testing::make_problem(testing::Scene::kRandom, size, random);
    pose = testing::perturbed(problem.cam2_from_cam1, 0.003, 0.01, random);
    std::vector<double> z1, z2, none(size, 0.0);
    for (std::size_t i = 0; i < size; ++i) z1.push_back(problem.X1[i].z()), z2.push_back(problem.X2[i].z());
    for (const ImageSurface surface : testing::kSurfaces) {
      const int s = static_cast<int>(surface);
      x1[s] = testing::noisy_rays(problem.x1, surface, kSigma, random);
      x2[s] = testing::noisy_rays(problem.x2, surface, kSigma, random);
      fill_ray_pairs(pairs[s], x1[s], x2[s], surface);
      fill_points_and_rays(points[s], problem.X1, x2[s], surface);
    }
    fill_rgbd_pair(both, x1[0], z1, x2[0], z2, {}, kSigma);
    fill_rgbd_pair(first, x1[0], z1, x2[0], none, {}, kSigma);
    fill_rgbd_pair(second, x1[0], none, x2[0], z2, {}, kSigma);
  }

  std::vector<std::pair<std::string, Kernel>> kernels() const {
    return {
        {"sampson plane",
         [&](auto& p, auto& l) { return sum_sampson_plane(pairs[0], kernel_pose(p), kSigma, l); }},
        {"sampson sphere",
         [&](auto& p, auto& l) { return sum_sampson_sphere(pairs[1], kernel_pose(p), kSigma, l); }},
        {"projection plane",
         [&](auto& p, auto& l) { return sum_projection_plane(points[0], kernel_pose(p), kSigma, l); }},
        {"projection sphere",
         [&](auto& p, auto& l) { return sum_projection_sphere(points[1], kernel_pose(p), kSigma, l); }},
        {"registration", [&](auto& p, auto& l) { return sum_registration(both.both, kernel_pose(p), l); }},
        {"point 1 on ray 2",
         [&](auto& p, auto& l) { return sum_point1_on_ray2(first.first, kernel_pose(p), kSigma, l); }},
        {"point 2 on ray 1",
         [&](auto& p, auto& l) { return sum_point2_on_ray1(second.second, kernel_pose(p), kSigma, l); }}};
  }
  // These live on |t| = 1.
  std::vector<std::pair<std::string, Kernel>> unit_kernels() const {
    return {{"reprojection plane",
             [&](auto& p, auto& l) { return sum_reprojection_plane(pairs[0], kernel_pose(p), kSigma, l); }},
            {"reprojection sphere",
             [&](auto& p, auto& l) { return sum_reprojection_sphere(pairs[1], kernel_pose(p), kSigma, l); }}};
  }

  Random random;
  testing::TwoViewProblem problem;
  Pose pose;
  std::vector<Eigen::Vector3d> x1[2], x2[2];
  PointColumns pairs[2], points[2];
  RgbdColumns both, first, second;
};

template <typename Motion>
void expect_numeric_gradient(const std::string& name, const Kernel& kernel, const Pose& pose) {
  // Truncated and Huber have kinks; the smooth losses test the weighing.
  for (const Loss kind : {Loss::kTrivial, Loss::kCauchy, Loss::kTukey}) {
    const RobustLoss loss{kind, 6};
    const auto g = normal_equations<Motion>(kernel(pose, loss), pose).g;
    typename Motion::Step numeric;
    const double h = 1e-6;
    for (int k = 0; k < Motion::kDof; ++k) {
      const typename Motion::Step d = h * Motion::Step::Unit(k);
      numeric[k] =
          (kernel(Motion::move(pose, d), loss).cost - kernel(Motion::move(pose, -d), loss).cost) / (4 * h);
    }
    EXPECT_LT((g - numeric).norm(), 2e-4 * numeric.norm()) << name << " loss " << int(kind);
  }
}

TEST(RefineKernels, GradientIsTheNumericDerivativeOfTheCost) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Fixture fixture(21, seed);
    for (const auto& [name, kernel] : fixture.kernels())
      expect_numeric_gradient<RigidMotion>(name, kernel, fixture.pose);
    const Pose unit{fixture.pose.R, fixture.pose.t.normalized()};
    for (const auto& [name, kernel] : fixture.unit_kernels())
      expect_numeric_gradient<MotionUpToScale>(name, kernel, unit);
  }
}

TEST(RefineKernels, SumsAreTheSumsOverTheGeometry) {
  const Fixture fixture(23);
  const Pose unit{fixture.pose.R, fixture.pose.t.normalized()};
  for (const ImageSurface surface : testing::kSurfaces)
    for (const Loss kind : kLosses) {
      const int s = static_cast<int>(surface);
      const RobustLoss loss{kind, 2};
      double sampson = 0, reprojection = 0;
      Vector6d g = Vector6d::Zero();
      Matrix6d H = Matrix6d::Zero();
      for (std::size_t i = 0; i < fixture.problem.X1.size(); ++i) {
        const Eigen::Vector3d a = on_surface("", fixture.x1[s][i], surface),
                              b = on_surface("", fixture.x2[s][i], surface);
        Jacobian16 J;
        const double r = sampson_residual(unit, a, b, surface, &J) / kSigma;
        J /= kSigma;
        sampson += loss.price(r * r);
        g += loss.weight(r * r) * J.transpose() * r;
        H += loss.weight(r * r) * J.transpose() * J;
        reprojection += loss.price(nearest_meeting_rays(unit, a, b, surface).cost / (kSigma * kSigma));
      }
      const KernelPose k = kernel_pose(unit);
      const bool plane = surface == ImageSurface::kPlane;
      const NormalSums found =
          (plane ? sum_sampson_plane : sum_sampson_sphere)(fixture.pairs[s], k, kSigma, loss);
      EXPECT_NEAR(found.cost, sampson, 1e-9 * sampson);
      const auto normal = normal_equations<RigidMotion>(found, unit);
      EXPECT_LT((normal.g - g).norm(), 1e-9 * g.norm());
      EXPECT_LT((normal.H - H).norm(), 1e-9 * H.norm());
      const NormalSums exact =
          (plane ? sum_reprojection_plane : sum_reprojection_sphere)(fixture.pairs[s], k, kSigma, loss);
      EXPECT_NEAR(exact.cost, reprojection, 1e-7 * reprojection);
    }
}

TEST(RefineKernels, ProjectionIsTheSumOfTheGeometrysResiduals) {
  const Fixture fixture(10);
  double plane = 0, sphere = 0;
  Matrix6d H[2] = {Matrix6d::Zero(), Matrix6d::Zero()};
  for (std::size_t i = 0; i < 10; ++i) {
    Jacobian26 J;
    plane += reprojection_residual(fixture.pose, fixture.problem.X1[i], fixture.x2[0][i], &J).squaredNorm();
    H[0] += J.transpose() * J;
    sphere += bearing_angle_residual(fixture.pose, fixture.problem.X1[i], fixture.x2[1][i], &J).squaredNorm();
    H[1] += J.transpose() * J;
  }
  const double k = 1 / (kSigma * kSigma);
  const NormalSums p = sum_projection_plane(fixture.points[0], kernel_pose(fixture.pose), kSigma, {});
  const NormalSums s = sum_projection_sphere(fixture.points[1], kernel_pose(fixture.pose), kSigma, {});
  EXPECT_NEAR(p.cost, k * plane, 1e-9 * k * plane);
  EXPECT_NEAR(s.cost, k * sphere, 1e-4 * k * sphere);  // the chord is shorter than the arc
  EXPECT_LT((normal_equations<RigidMotion>(p, fixture.pose).H - k * H[0]).norm(), 1e-9 * k * H[0].norm());
  EXPECT_LT((normal_equations<RigidMotion>(s, fixture.pose).H - k * H[1]).norm(), 1e-3 * k * H[1].norm());
}

// Whatever the number of points, the rows that fill up the last register add nothing.
TEST(RefineKernels, FillingRowsAddNothing) {
  for (const std::size_t size : {5, 6, 7, 8, 9}) {
    const Fixture fixture(size);
    PointColumns one, rest;
    std::vector<std::uint32_t> others;
    for (std::uint32_t i = 1; i < size; ++i) others.push_back(i);
    const std::uint32_t zero[] = {0};
    for (const ImageSurface surface : testing::kSurfaces) {
      const int s = static_cast<int>(surface);
      fill_ray_pairs(one, fixture.x1[s], fixture.x2[s], surface, zero);
      fill_ray_pairs(rest, fixture.x1[s], fixture.x2[s], surface, others);
      const auto sum = surface == ImageSurface::kPlane ? sum_sampson_plane : sum_sampson_sphere;
      const KernelPose k = kernel_pose(fixture.pose);
      NormalSums parts = sum(one, k, kSigma, {});
      parts += sum(rest, k, kSigma, {});
      const NormalSums whole = sum(fixture.pairs[s], k, kSigma, {});
      EXPECT_NEAR(whole.cost, parts.cost, 1e-9 * whole.cost);
      for (int n = 0; n < 21; ++n) EXPECT_NEAR(whole.H[n], parts.H[n], 1e-9 * std::abs(whole.H[0]));
    }
  }
}

TEST(RefineKernels, APointBehindTheCameraPaysAndPullsNowhere) {
  const std::vector<Eigen::Vector3d> X = {{0.1, 0.2, -3}}, x = {{0, 0, 1}};
  PointColumns columns;
  fill_points_and_rays(columns, X, x, ImageSurface::kPlane);
  const NormalSums sums = sum_projection_plane(columns, kernel_pose(Pose{}), kSigma, {Loss::kTruncated, 3});
  EXPECT_EQ(sums.cost, 9);
  for (const double h : sums.H) EXPECT_EQ(h, 0);
  EXPECT_GT(sum_projection_plane(columns, kernel_pose(Pose{}), kSigma, {}).cost, 1e9);
}

}  // namespace
}  // namespace framewise
