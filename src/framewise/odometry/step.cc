// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step.h"

#include <algorithm>
#include <vector>

#include "framewise/features/matching.h"
#include "framewise/odometry/scale.h"
#include "framewise/robust/registration.h"
#include "framewise/robust/relative_pose.h"

namespace framewise {
namespace {

// What two observations share: bearings of every match, points where both depths are known.
struct SharedSight {
  std::vector<Bearing> x1, x2;
  std::vector<Eigen::Vector3d> X1, X2;  // of the same matches; NaN where depth is unknown
  std::vector<Eigen::Vector3d> known1, known2;
};

SharedSight share(const Observation& frame1, const Observation& frame2,
                  const std::vector<FeatureMatch>& matches) {
  SharedSight sight;
  for (const FeatureMatch& match : matches) {
    const Eigen::Vector3d &X1 = frame1.points[match.index1], &X2 = frame2.points[match.index2];
    sight.x1.push_back(frame1.bearings[match.index1]);
    sight.x2.push_back(frame2.bearings[match.index2]);
    sight.X1.push_back(X1);
    sight.X2.push_back(X2);
    if (!X1.allFinite() || !X2.allFinite()) continue;
    sight.known1.push_back(X1);
    sight.known2.push_back(X2);
  }
  return sight;
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

Step register_points(Step step, const SharedSight& sight, const OdometryOptions& options,
                     std::uint64_t seed) {
  if (static_cast<int>(sight.known1.size()) < options.min_inliers) {
    if (step.matches >= options.min_inliers) step.status = Status::kNoDepth;
    return step;
  }
  RegistrationOptions registration;
  registration.ransac = options.ransac;
  registration.ransac.seed = seed;
  registration.max_error = options.max_error_m;
  return with_estimate(step, estimate_registration(sight.known1, sight.known2, registration),
                       options.min_inliers);
}

Step relate_bearings(Step step, const SharedSight& sight, const Camera& camera,
                     const OdometryOptions& options, std::uint64_t seed, std::optional<double> true_length) {
  if (step.matches < options.min_inliers) return step;
  RelativePoseOptions relative;
  relative.ransac = options.ransac;
  relative.ransac.seed = seed;
  relative.solver = RelativePoseSolver::kEightPoint;
  relative.max_error = options.max_error_px / camera.fx;
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
  const SharedSight sight = share(frame1, frame2, matches);
  return options.solver == "kabsch" ? register_points(step, sight, options, seed)
                                    : relate_bearings(step, sight, camera, options, seed, true_length);
}

}  // namespace framewise
