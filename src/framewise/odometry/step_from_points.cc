// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step_from_points.h"

#include <cmath>

#include "framewise/odometry/step_from_estimate.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/rgbd_pose.h"
#include "framewise/robust/single_sample.h"
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

// Registration among the inliers of a coarser one, with half its threshold; inliers counted among all points.
std::optional<Estimate> register_inliers(const SharedPoints& points, const Estimate& coarse,
                                         RegistrationOptions options) {
  options.max_error /= 2;
  const SharedPoints kept = points.only(coarse.inliers);
  auto fine = estimate_registration(kept.X1, kept.X2, options);
  if (!fine) return fine;
  const std::vector<std::uint8_t> among_kept = fine->inliers;
  fine->inliers.assign(points.X1.size(), 0);
  for (std::size_t i = 0, k = 0; i < points.X1.size(); ++i)
    if (coarse.inliers[i]) fine->inliers[i] = among_kept[k++];
  fine->iterations += coarse.iterations;
  fine->iterations_theory += coarse.iterations_theory;
  return fine;
}

std::optional<Estimate> registration_of(const SharedPoints& points, const OdometryOptions& options,
                                        std::uint64_t seed) {
  if (options.ransac_scheme == "off")
    return estimate_registration_from_one_sample(points.X1, points.X2, seed);
  RegistrationOptions registration;
  registration.ransac = options.ransac;
  registration.ransac.seed = seed;
  registration.max_error = options.max_error_m;
  const auto estimate = estimate_registration(points.X1, points.X2, registration);
  if (options.ransac_scheme != "two-stage" || !estimate) return estimate;
  return register_inliers(points, *estimate, registration);
}

Step step_by_kabsch(Step step, const SharedPoints& points, const OdometryOptions& options,
                    std::uint64_t seed) {
  const auto estimate = registration_of(points, options, seed);
  step = with_estimate(step, estimate, options.min_inliers);
  if (!is_measured(step.status)) return step;
  const SharedPoints inliers = points.only(estimate->inliers);
  step.inlier_mask.assign(step.matches, 0);
  for (const std::size_t i : inliers.index) step.inlier_mask[i] = 1;
  if (options.refine == "none" || options.ransac_scheme != "on") return step;

  RefineOptions refine;
  refine.loss = {Loss::kCauchy, 2.0};
  const auto refined =
      refine_registration(step.cam2_from_cam1, inliers.X1, inliers.S1, inliers.X2, inliers.S2, refine);
  step.cam2_from_cam1 = refined.pose;
  step.covariance = refined.covariance;
  return step;
}

Step step_by_p3p(Step step, const Correspondences& shared, const Camera& camera,
                 const OdometryOptions& options, std::uint64_t seed) {
  RgbdPoseOptions rgbd;
  rgbd.ransac = options.ransac;
  rgbd.ransac.seed = seed;
  rgbd.max_error = options.max_error_px / std::abs(camera.fx);
  rgbd.depth_noise = options.depth_noise;
  const auto estimate = estimate_rgbd_pose(shared.x1, shared.z1, shared.x2, shared.z2, rgbd);
  step = with_estimate(step, estimate, options.min_inliers);
  if (is_measured(step.status)) step.inlier_mask = estimate->inliers;
  return step;
}

}  // namespace

Step step_from_points(Step step, const Correspondences& shared, const Camera& camera,
                      const OdometryOptions& options, std::uint64_t seed) {
  const SharedPoints points = points_of(shared, options.depth_noise);
  if (static_cast<int>(points.X1.size()) < options.min_inliers) {
    if (step.matches >= options.min_inliers) step.status = Status::kNoDepth;
    return step;
  }
  return options.solver == "p3p" ? step_by_p3p(step, shared, camera, options, seed)
                                 : step_by_kabsch(step, points, options, seed);
}

}  // namespace framewise
