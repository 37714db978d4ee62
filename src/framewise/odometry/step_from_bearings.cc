// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/step_from_bearings.h"

#include <algorithm>
#include <cmath>

#include "framewise/odometry/essential_by_opencv.h"
#include "framewise/odometry/scale.h"
#include "framewise/odometry/step_from_estimate.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/robust/single_sample.h"
#include "framewise/robust/two_stage.h"
#include "framewise/solvers/refine_rgbd_pair.h"

namespace framewise {
namespace {

const auto kUnknown = std::numeric_limits<double>::quiet_NaN();

std::optional<Estimate> relative_pose(const Correspondences& shared, const Camera& camera,
                                      const OdometryOptions& options, std::uint64_t seed,
                                      const std::optional<Eigen::Matrix3d>& rotation) {
  if (options.solver == "opencv-essential")
    return essential_by_opencv(shared, options.max_error_px / std::abs(camera.fx), options.ransac.confidence);
  RelativePoseOptions relative;
  relative.ransac = options.ransac;
  relative.ransac.seed = seed;
  relative.solver = options.relative_pose_solver();
  relative.measure = options.inlier_measure();
  relative.refinement_error = options.max_error_px / std::abs(camera.fx);
  relative.max_error = relative.measure == InlierMeasure::kBearingEuclidean ? options.max_error_rad
                                                                            : relative.refinement_error;
  relative.rotation = rotation;
  relative.final_refinement = options.refine != "none";
  if (options.ransac_scheme == "off")
    return estimate_relative_pose_from_one_sample(shared.x1, shared.x2, relative);
  if (options.ransac_scheme == "two-stage") {
    relative.ransac.local_optimisation = false;
    return estimate_relative_pose_two_stage(shared.x1, shared.x2,
                                            {relative, relative.max_error / 2, relative.ransac.confidence});
  }
  return estimate_relative_pose(shared.x1, shared.x2, relative);
}

// The points that the correspondences have depth for, NaN where it is unknown.
struct Points {
  std::vector<Eigen::Vector3d> X1, X2;

  explicit Points(const Correspondences& shared) {
    for (std::size_t i = 0; i < shared.size(); ++i) {
      X1.push_back(point_at_depth(shared.x1[i], shared.z1[i]));
      X2.push_back(point_at_depth(shared.x2[i], shared.z2[i]));
    }
  }
};

Step without_length(Step step, Status status) {
  step.status = status;
  step.covariance.setConstant(kUnknown);
  return step;
}

Step with_length(Step step, double length) {
  step.cam2_from_cam1.t *= length;
  step.covariance.rightCols<3>() *= length;
  step.covariance.bottomRows<3>() *= length;
  return step;
}

// Rotation and translation once more, from rays and depths together, each with its noise. What little
// parallax or none leaves unknown, depth tells.
Step refined_with_depth(Step step, const Correspondences& shared, const OdometryOptions& options) {
  std::vector<Eigen::Vector3d> x1, x2;
  std::vector<double> z1, z2, sigmas;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (!step.inlier_mask[i] || !(shared.x1[i].z() > 0 && shared.x2[i].z() > 0)) continue;
    x1.push_back(shared.x1[i]), x2.push_back(shared.x2[i]);
    z1.push_back(shared.z1[i]), z2.push_back(shared.z2[i]);
    sigmas.push_back(shared.sigma2[i]);
  }
  if (x1.size() < 3) return step;
  RefineOptions refine;
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  refine.sigma = *middle;
  refine.loss = {Loss::kCauchy, 2.0};
  const auto refined = refine_rgbd_pair(step.cam2_from_cam1, x1, z1, x2, z2, options.depth_noise, refine);
  if (!refined.covariance.allFinite()) return step;  // the depths do not suffice
  step.status = Status::kOk;
  step.cam2_from_cam1 = refined.pose;
  step.covariance = refined.covariance;
  return step;
}

Step scaled_by_depth(Step step, const Correspondences& shared, const OdometryOptions& options) {
  const Points points(shared);
  const auto length = length_from_depth(step.cam2_from_cam1, points.X1, points.X2, step.inlier_mask);
  const bool turned_only = step.status == Status::kRotationOnly;
  if (!length) return turned_only ? step : without_length(step, Status::kNoDepth);
  if (!turned_only) step = with_length(step, *length);
  const bool refines = options.refine != "none" && options.ransac_scheme == "on" && !options.needs_rotation();
  return refines ? refined_with_depth(step, shared, options) : step;
}

Step translated_by_centroids(Step step, const Correspondences& shared) {
  const Points points(shared);
  const auto t = translation_from_centroids(step.cam2_from_cam1.R, points.X1, points.X2, step.inlier_mask);
  if (!t) return without_length(step, Status::kNoDepth);
  step.status = Status::kOk;
  step.cam2_from_cam1.t = *t;
  step.covariance.rightCols<3>().setConstant(kUnknown);
  step.covariance.bottomRows<3>().setConstant(kUnknown);
  return step;
}

}  // namespace

Step step_from_bearings(Step step, const Correspondences& shared, const Camera& camera,
                        const OdometryOptions& options, std::uint64_t seed, const StepKnowledge& known) {
  if (step.matches < options.min_inliers) return step;
  if (options.needs_rotation() && !known.rotation) return step;
  const auto estimate = relative_pose(shared, camera, options, seed, known.rotation);
  step = with_estimate(step, estimate, options.min_inliers);
  if (!is_measured(step.status)) return step;
  step.inlier_mask = estimate->inliers;

  if (options.scale == "depth") return scaled_by_depth(step, shared, options);
  if (options.scale == "centroid") return translated_by_centroids(step, shared);
  if (step.status == Status::kRotationOnly || options.scale == "none") return step;
  if (options.scale == "truth")
    return known.true_length ? with_length(step, *known.true_length) : without_length(step, Status::kLost);
  const Points points(shared);
  step.length_from_depth = length_from_depth(step.cam2_from_cam1, points.X1, points.X2, step.inlier_mask);
  return step;
}

}  // namespace framewise
