// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"
#include "framewise/geometry/so3.h"
#include "framewise/solvers/problems_for_tests.h"

// Noise to refine through, and what an honest covariance must satisfy.
namespace framewise::testing {

inline constexpr ImageSurface kSurfaces[] = {ImageSurface::kPlane, ImageSurface::kSphere};

// A ray with image noise sigma: on the plane in x and y, on the sphere in the tangent plane.
inline Eigen::Vector3d noisy_ray(const Eigen::Vector3d& x, ImageSurface surface, double sigma,
                                 Random& random) {
  if (surface == ImageSurface::kPlane)
    return x / x.z() + Eigen::Vector3d(sigma * random.normal(), sigma * random.normal(), 0);
  return sphere_exp(x.normalized(), {sigma * random.normal(), sigma * random.normal()});
}

inline std::vector<Eigen::Vector3d> noisy_rays(const std::vector<Eigen::Vector3d>& x, ImageSurface surface,
                                               double sigma, Random& random) {
  std::vector<Eigen::Vector3d> result;
  for (const auto& ray : x) result.push_back(noisy_ray(ray, surface, sigma, random));
  return result;
}

inline Pose perturbed(const Pose& pose, double angle, double shift, Random& random) {
  return {pose.R * so3_exp(angle * random.direction()), pose.t + shift * random.direction()};
}

// The tangent vector from the estimate to the truth.
inline Vector6d rigid_error(const Pose& estimate, const Pose& truth) {
  Vector6d e;
  e << so3_log(estimate.R.transpose() * truth.R), truth.t - estimate.t;
  return e;
}
// The same for |t| = 1, in the coordinates of sphere_tangent(estimate.t).
inline Eigen::Matrix<double, 5, 1> error_up_to_scale(const Pose& estimate, const Pose& truth) {
  const Eigen::Vector2d across = sphere_tangent(estimate.t).transpose() * truth.t.normalized();
  const double angle = direction_error(estimate.t, truth.t);
  Eigen::Matrix<double, 5, 1> e;
  e << so3_log(estimate.R.transpose() * truth.R), across * (angle / std::max(across.norm(), 1e-300));
  return e;
}
inline Eigen::Matrix<double, 5, 5> covariance_up_to_scale(const Pose& estimate, const Matrix6d& covariance) {
  Eigen::Matrix<double, 6, 5> basis = Eigen::Matrix<double, 6, 5>::Zero();
  basis.topLeftCorner<3, 3>().setIdentity();
  basis.bottomRightCorner<3, 2>() = sphere_tangent(estimate.t);
  return basis.transpose() * covariance * basis;
}

// Errors of many trials in units of their covariance.
class Consistency {
 public:
  template <typename Error, typename Covariance>
  void add(const Error& error, const Covariance& covariance) {
    const Eigen::LLT<Covariance> llt(covariance);
    const Eigen::VectorXd whitened = llt.matrixL().solve(error);
    if (trials_ == 0) sum_ = Eigen::VectorXd::Zero(error.size());
    sum_ += whitened;
    nees_ += whitened.squaredNorm() / static_cast<double>(error.size());
    ++trials_;
  }
  // Mean normalised estimation error squared, per degree of freedom: 1 where the covariance is true.
  double nees() const { return nees_ / trials_; }
  // The largest mean error of a coordinate, in standard errors.
  double bias() const { return (sum_ / trials_).cwiseAbs().maxCoeff() * std::sqrt(trials_); }

 private:
  int trials_ = 0;
  double nees_ = 0;
  Eigen::VectorXd sum_;
};

}  // namespace framewise::testing
