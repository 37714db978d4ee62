// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step.h"

#include <cmath>

#include "framewise/odometry/scale.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/solvers/refine_registration.h"

namespace framewise {
namespace {

// The correspondences whose points are known in both frames, with their covariances (m^2).
struct SharedPoints {
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<Eigen::Matrix3d> S1, S2;
  std::vector<std::size_t> index;  // among all correspondences

  SharedPoints only(const std::vector<std::uint8_t>& inliers) const {
    SharedPoints kept;
    for (std::size_t i = 0; i < X1.size(); ++i)
      if (inliers[i]) kept.add(index[i], X1[i], S1[i], X2[i], S2[i]);
    return kept;
  }
  void add(std::size_t i, const Eigen::Vector3d& x1, const Eigen::Matrix3d& s1, const Eigen::Vector3d& x2,
           const Eigen::Matrix3d& s2) {
    index.push_back(i), X1.push_back(x1), S1.push_back(s1), X2.push_back(x2), S2.push_back(s2);
  }
};

SharedPoints points_of(const Correspondences& shared, const DepthNoise& noise) {
  const auto covariance = [&](const Bearing& x, const Eigen::Vector3d& X, double sigma) {
    return point_covariance(x, X.z(), sigma, noise.sigma(X.z()));
  };
  SharedPoints points;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    const Eigen::Vector3d X1 = point_at_depth(shared.x1[i], shared.z1[i]);
    const Eigen::Vector3d X2 = point_at_depth(shared.x2[i], shared.z2[i]);
    if (X1.allFinite() && X2.allFinite())
      points.add(i, X1, covariance(shared.x1[i], X1, shared.sigma1[i]), X2,
                 covariance(shared.x2[i], X2, shared.sigma2[i]));
  }
  return points;
}

Step with_estimate(Step step, const std::optional<Estimate>& estimate, int min_inliers) {
  if (!estimate || static_cast<int>(estimate->num_inliers) < min_inliers) return step;
  step.inliers = static_cast<int>(estimate->num_inliers);
  step.iterations = estimate->iterations;
  step.iterations_theory = estimate->iterations_theory;
  step.cam2_from_cam1 = estimate->cam2_from_cam1;
  step.covariance = estimate->covariance;
  switch (estimate->kind) {
    case EstimateKind::kFull:
      step.status = Status::kOk;
      break;
    case EstimateKind::kLowParallax:
      step.status = Status::kLowParallax;
      break;
    case EstimateKind::kRotationOnly:
      step.status = Status::kRotationOnly;
      step.cam2_from_cam1.t.setZero();
      break;
  }
  return step;
}

Step register_points(Step step, const SharedPoints& points, const OdometryOptions& options,
                     std::uint64_t seed) {
  if (static_cast<int>(points.X1.size()) < options.min_inliers) {
    if (step.matches >= options.min_inliers) step.status = Status::kNoDepth;
    return step;
  }
  RegistrationOptions registration;
  registration.ransac = options.ransac;
  registration.ransac.seed = seed;
  registration.max_error = options.max_error_m;
  const auto estimate = estimate_registration(points.X1, points.X2, registration);
  step = with_estimate(step, estimate, options.min_inliers);
  if (!is_measured(step.status)) return step;
  const SharedPoints inliers = points.only(estimate->inliers);
  step.inlier_mask.assign(step.matches, 0);
  for (const std::size_t i : inliers.index) step.inlier_mask[i] = 1;
  if (options.refine == "none") return step;

  RefineOptions refine;
  refine.loss = {Loss::kCauchy, 2.0};
  const auto refined =
      refine_registration(step.cam2_from_cam1, inliers.X1, inliers.S1, inliers.X2, inliers.S2, refine);
  step.cam2_from_cam1 = refined.pose;
  step.covariance = refined.covariance;
  return step;
}

// Length of the step (m); empty where nothing tells it.
std::optional<double> length_of(const Pose& cam2_from_cam1, const Correspondences& shared,
                                const std::vector<std::uint8_t>& inliers, const OdometryOptions& options,
                                std::optional<double> true_length) {
  if (options.scale == "truth") return true_length;
  std::vector<Eigen::Vector3d> X1, X2;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    X1.push_back(point_at_depth(shared.x1[i], shared.z1[i]));
    X2.push_back(point_at_depth(shared.x2[i], shared.z2[i]));
  }
  return length_from_depth(cam2_from_cam1, X1, X2, inliers);
}

Step relate_bearings(Step step, const Correspondences& shared, const Camera& camera,
                     const OdometryOptions& options, std::uint64_t seed, std::optional<double> true_length) {
  if (step.matches < options.min_inliers) return step;
  RelativePoseOptions relative;
  relative.ransac = options.ransac;
  relative.ransac.seed = seed;
  relative.solver = options.relative_pose_solver();
  relative.max_error = options.max_error_px / std::abs(camera.fx);
  relative.final_refinement = options.refine != "none";
  const auto estimate = estimate_relative_pose(shared.x1, shared.x2, relative);
  step = with_estimate(step, estimate, options.min_inliers);
  if (!is_measured(step.status)) return step;
  step.inlier_mask = estimate->inliers;
  if (step.status == Status::kRotationOnly || options.scale == "none") return step;

  const auto length = length_of(step.cam2_from_cam1, shared, estimate->inliers, options, true_length);
  if (!length) {
    step.status = options.scale == "truth" ? Status::kLost : Status::kNoDepth;
    step.covariance.setConstant(std::numeric_limits<double>::quiet_NaN());
    return step;
  }
  step.cam2_from_cam1.t *= *length;
  step.covariance.rightCols<3>() *= *length;
  step.covariance.bottomRows<3>() *= *length;
  return step;
}

}  // namespace

Step estimate_step(const Correspondences& correspondences, const Camera& camera,
                   const OdometryOptions& options, std::uint64_t seed, std::optional<double> true_length) {
  Step step;
  step.matches = static_cast<int>(correspondences.size());
  if (options.needs_depth() && !correspondences.has_depth) {
    step.status = Status::kNoDepth;
    return step;
  }
  if (options.uses_points())
    return register_points(step, points_of(correspondences, options.depth_noise), options, seed);
  return relate_bearings(step, correspondences, camera, options, seed, true_length);
}

}  // namespace framewise
