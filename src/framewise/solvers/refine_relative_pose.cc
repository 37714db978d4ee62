// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/refine_relative_pose.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/linear_algebra.h"
#include "framewise/solvers/levenberg_marquardt.h"
#include "framewise/solvers/refine_input.h"

namespace framewise {
namespace {

NormalSums sum_epipolar(const PointColumns& pairs, const Pose& pose, const RefineOptions& options,
                        EpipolarResidual residual) {
  const KernelPose k = kernel_pose(pose);
  const bool plane = options.surface == ImageSurface::kPlane;
  if (residual == EpipolarResidual::kSampson)
    return plane ? sum_sampson_plane(pairs, k, options.sigma, options.loss)
                 : sum_sampson_sphere(pairs, k, options.sigma, options.loss);
  return plane ? sum_reprojection_plane(pairs, k, options.sigma, options.loss)
               : sum_reprojection_sphere(pairs, k, options.sigma, options.loss);
}

struct Eigenpair {
  double value;
  Eigen::Vector2d vector;
};

Eigenpair smallest(const Eigen::Matrix2d& M) {
  const double m = 0.5 * (M(0, 0) - M(1, 1)), h = std::hypot(m, M(0, 1));
  const Eigen::Vector2d v = m >= 0 ? Eigen::Vector2d(-M(0, 1), m + h) : Eigen::Vector2d(h - m, -M(0, 1));
  const double length = v.norm(), larger = 0.5 * M.trace() + h;
  return {larger > 0 ? M.determinant() / larger : 0,
          length > 0 ? Eigen::Vector2d(v / length) : Eigen::Vector2d(1, 0)};
}

// Information about the direction of t once the rotation is free: the Schur complement.
Eigen::Matrix2d information_of_direction(const NormalEquations<MotionUpToScale>& normal) {
  const Eigen::Matrix<double, 3, 2> across = normal.H.topRightCorner<3, 2>();
  const Cholesky<3> rotation(normal.H.topLeftCorner<3, 3>());
  return normal.H.bottomRightCorner<2, 2>() - across.transpose() * (rotation.inverse() * across);
}

}  // namespace

Refinement refine_relative_pose(const Pose& initial, const PointColumns& ray_pairs,
                                const RefineOptions& options, EpipolarResidual residual) {
  options.check();
  check_pose(initial);
  check_at_least("x1", ray_pairs.rows(), 5);
  if (!(initial.t.norm() > 0)) throw std::invalid_argument("initial.t is 0, expected a direction");
  const auto sums_at = [&](const Pose& pose) { return sum_epipolar(ray_pairs, pose, options, residual); };
  return minimise<MotionUpToScale>({initial.R, initial.t.normalized()}, sums_at, options);
}

Refinement refine_relative_pose(const Pose& initial, std::span<const Eigen::Vector3d> x1,
                                std::span<const Eigen::Vector3d> x2, const RefineOptions& options,
                                EpipolarResidual residual) {
  options.check();
  PointColumns ray_pairs;
  fill_ray_pairs(ray_pairs, x1, x2, options.surface);
  return refine_relative_pose(initial, ray_pairs, options, residual);
}

DirectionInformation direction_information(const Pose& pose, const PointColumns& ray_pairs,
                                           const RefineOptions& options) {
  // The derivative along t is (R x1 x x2) / sqrt(D) / sigma; the noise of both rays, sigma^2 (I - n n') with
  // the surface's normals n, gives it the covariance summed here.
  const bool plane = options.surface == ImageSurface::kPlane;
  const Eigen::Vector3d t = pose.t.normalized();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const auto column = [&](std::size_t first, std::size_t i) -> Eigen::Vector3d {
    return {ray_pairs.column(first)[i], ray_pairs.column(first + 1)[i], ray_pairs.column(first + 2)[i]};
  };
  const auto turned = [](const Eigen::Vector3d& x, const Eigen::Vector3d& n) -> Eigen::Matrix3d {
    const Eigen::Vector3d k = x.cross(n);  // [x]x (I - n n') [x]x'
    return x.squaredNorm() * Eigen::Matrix3d::Identity() - x * x.transpose() - k * k.transpose();
  };
  for (std::size_t i = 0; i < ray_pairs.rows(); ++i) {
    const Eigen::Vector3d p = pose.R * column(1, i), x2 = column(4, i);
    const Eigen::Vector3d n1 = plane ? Eigen::Vector3d(pose.R.col(2)) : p;
    const Eigen::Vector3d n2 = plane ? Eigen::Vector3d(0, 0, 1) : x2;
    const Eigen::Vector3d l2 = t.cross(p), c = x2.cross(t);
    const double a = n2.dot(l2), b = n1.dot(c), r = c.dot(p);
    const double D = l2.squaredNorm() - a * a + c.squaredNorm() - b * b;
    if (!(D > 0)) continue;
    const double weight = options.loss.weight(r * r / D / (options.sigma * options.sigma));
    sum += (weight / D) * (turned(x2, n1) + turned(p, n2));
  }
  const Eigen::Matrix<double, 3, 2> B = sphere_tangent(t);
  const NormalSums sums = sum_epipolar(ray_pairs, {pose.R, t}, options, EpipolarResidual::kSampson);
  const Eigenpair worst =
      smallest(information_of_direction(normal_equations<MotionUpToScale>(sums, {pose.R, t})));
  return {std::max(worst.value, 0.0), worst.vector.dot(B.transpose() * sum * B * worst.vector)};
}

}  // namespace framewise
