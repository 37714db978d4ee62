// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step.h"

#include <cmath>
#include <vector>

#include "framewise/features/matching.h"
#include "framewise/features/patch_alignment.h"
#include "framewise/odometry/scale.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/solvers/refine_registration.h"

namespace framewise {
namespace {

// What two observations share: an entry for every match, in the same order in all.
struct Shared {
  std::vector<Bearing> x1, x2;
  std::vector<Eigen::Vector3d> X1, X2;  // NaN where depth is unknown
  std::vector<double> sigma1, sigma2;   // noise of the bearings (rad)
};

// Where the features of frame 2 are, to fractions of a pixel; and which of them were found there.
struct Positions {
  std::vector<cv::Point2f> pixels;
  std::vector<bool> moved;
};

Positions positions_in_frame2(const Observation& frame1, const Observation& frame2,
                              const std::vector<FeatureMatch>& matches, const OdometryOptions& options) {
  std::vector<cv::Point2f> pixels1, found;
  for (const FeatureMatch& match : matches) {
    pixels1.push_back(frame1.features.keypoints[match.index1].pt);
    found.push_back(frame2.features.keypoints[match.index2].pt);
  }
  Positions positions{found, std::vector<bool>(found.size(), false)};
  if (options.subpixel == "none") return positions;
  align_patches(frame1.gray, frame2.gray, pixels1, positions.pixels);
  for (std::size_t i = 0; i < found.size(); ++i) positions.moved[i] = positions.pixels[i] != found[i];
  return positions;
}

Shared share(const Observation& frame1, const Observation& frame2, const std::vector<FeatureMatch>& matches,
             const Camera& camera, const OdometryOptions& options) {
  const Positions positions = positions_in_frame2(frame1, frame2, matches, options);
  Shared shared;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto [index1, index2, distance] = matches[i];
    const Sighting& first = frame1.sightings[index1];
    const auto moved =
        positions.moved[i] ? sight(frame2.depth, positions.pixels[i], camera, options.depth) : std::nullopt;
    const Sighting& second = moved ? *moved : frame2.sightings[index2];
    shared.x1.push_back(first.bearing);
    shared.x2.push_back(second.bearing);
    shared.X1.push_back(first.point);
    shared.X2.push_back(second.point);
    const double sigma = options.keypoint_sigma_px / std::abs(camera.fx);
    shared.sigma1.push_back(sigma * frame1.features.scale(index1));
    shared.sigma2.push_back(sigma * frame2.features.scale(index2));
  }
  return shared;
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

SharedPoints points_of(const Shared& shared, const DepthNoise& noise) {
  const auto covariance = [&](const Bearing& x, const Eigen::Vector3d& X, double sigma) {
    return point_covariance(x, X.z(), sigma, noise.sigma(X.z()));
  };
  SharedPoints points;
  for (std::size_t i = 0; i < shared.x1.size(); ++i)
    if (shared.X1[i].allFinite() && shared.X2[i].allFinite())
      points.add(shared.X1[i], covariance(shared.x1[i], shared.X1[i], shared.sigma1[i]), shared.X2[i],
                 covariance(shared.x2[i], shared.X2[i], shared.sigma2[i]));
  return points;
}

Step with_estimate(Step step, const std::optional<Estimate>& estimate, int min_inliers) {
  if (!estimate || static_cast<int>(estimate->num_inliers) < min_inliers) return step;
  step.inliers = static_cast<int>(estimate->num_inliers);
  step.iterations = estimate->iterations;
  step.iterations_theory = estimate->iterations_theory;
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

Step relate_bearings(Step step, const Shared& shared, const Camera& camera, const OdometryOptions& options,
                     std::uint64_t seed, std::optional<double> true_length) {
  if (step.matches < options.min_inliers) return step;
  RelativePoseOptions relative;
  relative.ransac = options.ransac;
  relative.ransac.seed = seed;
  relative.solver = options.relative_pose_solver();
  relative.max_error = options.max_error_px / std::abs(camera.fx);
  relative.final_refinement = options.refine != "none";
  const auto estimate = estimate_relative_pose(shared.x1, shared.x2, relative);
  step = with_estimate(step, estimate, options.min_inliers);
  if (!is_measured(step.status) || step.status == Status::kRotationOnly || options.scale == "none")
    return step;

  const auto length = options.scale == "truth"
                          ? true_length
                          : length_from_depth(step.cam2_from_cam1, shared.X1, shared.X2, estimate->inliers);
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
  if (options.needs_depth() && (frame1.depth.empty() || frame2.depth.empty())) {
    step.status = Status::kNoDepth;
    return step;
  }
  const auto matches = match_brute_force(frame1.features.descriptors, frame2.features.descriptors);
  step.matches = static_cast<int>(matches.size());
  const Shared shared = share(frame1, frame2, matches, camera, options);
  if (options.uses_points())
    return register_points(step, points_of(shared, options.depth_noise), options, seed);
  return relate_bearings(step, shared, camera, options, seed, true_length);
}

}  // namespace framewise
