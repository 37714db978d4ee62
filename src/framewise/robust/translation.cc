// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/translation.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/linear_algebra.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/degeneracy.h"
#include "framewise/robust/epipolar_problem.h"
#include "framewise/robust/ransac.h"
#include "framewise/solvers/translation_npt.h"

namespace framewise {
namespace {

constexpr char kDoor[] = "estimate_translation";
constexpr double kWorstDirection = 6 * M_PI / 180;

// Least squares on the inliers; the weights turn the algebraic residual into Sampson's distance.
std::optional<Eigen::Vector3d> refit(const EpipolarProblem& problem, std::span<const Bearing> x1,
                                     std::span<const Bearing> x2, const Pose& pose, double max_error) {
  std::vector<Bearing> a, b;
  std::vector<double> weights;
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const double residual = problem.residual(pose, i);
    if (!(residual < max_error)) continue;
    const double algebraic = algebraic_residual(pose, x1[i], x2[i]);
    const Eigen::Vector3d l2 = pose.t.cross(pose.R * x1[i]), l1 = x2[i].cross(pose.t);
    a.push_back(x1[i]);
    b.push_back(x2[i]);
    weights.push_back(1 / std::max(l1.squaredNorm() + l2.squaredNorm() - 2 * algebraic * algebraic, 1e-12));
  }
  return translation_npt(a, b, pose.R, weights);
}

struct DirectionFit {
  Eigen::Matrix3d covariance;       // of the direction of t, at the noise that the inliers show
  double parallax_chi_squared = 0;  // of x2 - R x1
};
DirectionFit fit_direction(std::span<const Bearing> x1, std::span<const Bearing> x2, const Estimate& estimate,
                           ImageSurface surface) {
  const Pose& pose = estimate.cam2_from_cam1;
  const Eigen::Matrix<double, 3, 2> B = sphere_tangent(pose.t);
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  double squares = 0, parallaxes = 0;
  for (std::size_t i = 0; i < x1.size(); ++i) {
    if (!estimate.inliers[i]) continue;
    parallaxes += (pose.R * x1[i] - x2[i]).squaredNorm();
    const bool plane = surface == ImageSurface::kPlane;
    Jacobian16 J;
    const double r = sampson_residual(pose, plane ? Eigen::Vector3d(x1[i] / x1[i].z()) : x1[i],
                                      plane ? Eigen::Vector3d(x2[i] / x2[i].z()) : x2[i], surface, &J);
    const Eigen::RowVector2d j = J.tail<3>() * B;
    information += j.transpose() * j;
    squares += r * r;
  }
  const double variance = squares / static_cast<double>(std::max<std::size_t>(estimate.num_inliers, 3) - 2);
  return {B * (variance * information.inverse()) * B.transpose(), parallaxes / (2 * variance)};
}

}  // namespace

void TranslationOptions::check() const {
  ransac.check();
  check_positive(kDoor, "max_error", max_error);
  check_positive(kDoor, "min_inliers", min_inliers);
}

std::optional<Estimate> estimate_translation(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                             const Eigen::Matrix3d& R, const TranslationOptions& options) {
  options.check();
  check_same_size(kDoor, "x1", x1.size(), "x2", x2.size());
  check_bearings(kDoor, "x1", x1);
  check_bearings(kDoor, "x2", x2);
  check_rotation(kDoor, "R", R);
  if (x1.size() < 2) return std::nullopt;

  const std::vector<Bearing> unit1 = normalized(x1), unit2 = normalized(x2);
  RelativePoseOptions two_point;
  two_point.ransac = options.ransac;
  two_point.solver = RelativePoseSolver::kTwoPoint;
  two_point.max_error = options.max_error;
  two_point.rotation = R;
  const EpipolarProblem problem(unit1, unit2, two_point);
  const auto found = ransac(problem, options.ransac, options.max_error);
  if (!found) return std::nullopt;

  Estimate estimate;
  Pose& pose = estimate.cam2_from_cam1;
  pose = found->model.pose;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const auto t = refit(problem, unit1, unit2, pose, options.max_error);
    if (!t) break;
    pose.t = *t;
  }
  estimate.inliers.resize(x1.size());
  for (std::size_t i = 0; i < x1.size(); ++i) {
    estimate.inliers[i] = problem.residual(pose, i) < options.max_error;
    estimate.num_inliers += estimate.inliers[i];
  }
  if (estimate.num_inliers < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  estimate.score = found->tally.cost;
  estimate.iterations = found->iterations;
  estimate.iterations_theory = found->iterations_theory;
  const DirectionFit fit = fit_direction(unit1, unit2, estimate, problem.surface());
  estimate.covariance.setZero();
  estimate.covariance.bottomRightCorner<3, 3>() = fit.covariance;
  const double worst = symmetric_eigen(fit.covariance).values[2];
  if (is_mere_noise(fit.parallax_chi_squared, static_cast<double>(estimate.num_inliers))) {
    estimate.kind = EstimateKind::kRotationOnly;
    pose.t.setZero();
    estimate.covariance.bottomRightCorner<3, 3>().setConstant(std::numeric_limits<double>::quiet_NaN());
  } else if (!(worst < kWorstDirection * kWorstDirection)) {
    estimate.kind = EstimateKind::kLowParallax;
  }
  return estimate;
}

}  // namespace framewise
