// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step.h"

#include <cmath>
#include <vector>

#include "framewise/features/matching.h"
#include "framewise/odometry/scale.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/solvers/refine_registration.h"

namespace framewise {
namespace {

// What two observations share: the features of every match, in the same order.
struct SharedSight {
  std::vector<Bearing> x1, x2;
  std::vector<Eigen::Vector3d> X1, X2;  // NaN where depth is unknown
};

SharedSight share(const Observation& frame1, const Observation& frame2,
                  const std::vector<FeatureMatch>& matches) {
  SharedSight sight;
  for (const FeatureMatch& match : matches) {
    sight.x1.push_back(frame1.bearings[match.index1]);
    sight.x2.push_back(frame2.bearings[match.index2]);
    sight.X1.push_back(frame1.points[match.index1]);
    sight.X2.push_back(frame2.points[match.index2]);
  }
  return sight;
}

// The matches whose points are known in both frames, with their covariances (m^2).
struct SharedPoints {
  std::vector<Eigen::Vector3d> X1, X2;
  std::vector<Eigen::Matrix3d> S1, S2;

  SharedPoints only(const std::vector<std::uint8_t>& inliers) const {
    SharedPoints kept;
    for (std::size_t i = 0; i < X1.size(); ++i)
      if (inliers[i]) kept.add(X1[i], S1[i], X2[i], S2[i]);
    return kept;
  }
  void add(const Eigen::Vector3d& x1, const Eigen::Matrix3d& s1, const Eigen::Vector3d& x2,
           const Eigen::Matrix3d& s2) {
    X1.push_back(x1), S1.push_back(s1), X2.push_back(x2), S2.push_back(s2);
  }
};

SharedPoints share_points(const Observation& frame1, const Observation& frame2,
                          const std::vector<FeatureMatch>& matches, const Camera& camera,
                          const OdometryOptions& options) {
  const auto covariance = [&](const Observation& frame, int index) {
    const double sigma = options.keypoint_sigma_px * frame.features.scale(index) / std::abs(camera.fx);
    const double z = frame.points[index].z();
    return point_covariance(frame.bearings[index], z, sigma, options.depth_noise.sigma(z));
  };
  SharedPoints points;
  for (const FeatureMatch& m : matches)
    if (frame1.points[m.index1].allFinite() && frame2.points[m.index2].allFinite())
      points.add(frame1.points[m.index1], covariance(frame1, m.index1), frame2.points[m.index2],
                 covariance(frame2, m.index2));
  return points;
}

Step with_estimate(Step step, const std::optional<Estimate>& estimate, int min_inliers) {
  if (!estimate || static_cast<int>(estimate->num_inliers) < min_inliers) return step;
  step.inliers = static_cast<int>(estimate->num_inliers);
  step.cam2_from_cam1 = estimate->cam2_from_cam1;
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
  if (!is_measured(step.status) || options.refine == "none") return step;

  const SharedPoints inliers = points.only(estimate->inliers);
  RefineOptions refine;
  refine.loss = {Loss::kCauchy, 2.0};
  const auto refined =
      refine_registration(step.cam2_from_cam1, inliers.X1, inliers.S1, inliers.X2, inliers.S2, refine);
  step.cam2_from_cam1 = refined.pose;
  return step;
}

Step relate_bearings(Step step, const SharedSight& sight, const Camera& camera,
                     const OdometryOptions& options, std::uint64_t seed, std::optional<double> true_length) {
  if (step.matches < options.min_inliers) return step;
  RelativePoseOptions relative;
  relative.ransac = options.ransac;
  relative.ransac.seed = seed;
  relative.solver = RelativePoseSolver::kEightPoint;
  relative.max_error = options.max_error_px / std::abs(camera.fx);
  relative.final_refinement = options.refine != "none";
  const auto estimate = estimate_relative_pose(sight.x1, sight.x2, relative);
  step = with_estimate(step, estimate, options.min_inliers);
  if (!is_measured(step.status) || step.status == Status::kRotationOnly || options.scale == "none")
    return step;

  const auto length = options.scale == "truth"
                          ? true_length
                          : length_from_depth(step.cam2_from_cam1, sight.X1, sight.X2, estimate->inliers);
  if (length)
    step.cam2_from_cam1.t *= *length;
  else
    step.status = options.scale == "truth" ? Status::kLost : Status::kNoDepth;
  return step;
}

}  // namespace

Step estimate_step(const Observation& frame1, const Observation& frame2, const Camera& camera,
                   const OdometryOptions& options, std::uint64_t seed, std::optional<double> true_length) {
  Step step;
  if (options.needs_depth() && !(frame1.has_depth && frame2.has_depth)) {
    step.status = Status::kNoDepth;
    return step;
  }
  const auto matches = match_brute_force(frame1.features.descriptors, frame2.features.descriptors);
  step.matches = static_cast<int>(matches.size());
  if (options.solver == "kabsch")
    return register_points(step, share_points(frame1, frame2, matches, camera, options), options, seed);
  return relate_bearings(step, share(frame1, frame2, matches), camera, options, seed, true_length);
}

}  // namespace framewise
