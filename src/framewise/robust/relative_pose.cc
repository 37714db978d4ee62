// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/relative_pose.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "framewise/robust/bearings.h"
#include "framewise/robust/consensus.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/degeneracy.h"
#include "framewise/robust/epipolar_problem.h"
#include "framewise/robust/ransac.h"
#include "framewise/robust/rival_minima.h"
#include "framewise/robust/translation.h"
#include "framewise/solvers/decompose_essential.h"

namespace framewise {
namespace {

constexpr char kDoor[] = "estimate_relative_pose";

// The pose of the best hypothesis. Under Sampson's distance RANSAC leaves open which of the four of E it is.
Pose pose_of(const EpipolarModel& model, const TwoViews& views, const RelativePoseOptions& options) {
  if (options.measure == InlierMeasure::kReprojection) return model.pose;
  Pose pose = decompose_essential(model.E)[0];
  pose = choose_by_parallax(views, pose, options.max_error, options.max_error).pose;
  if (options.measure == InlierMeasure::kBearingEuclidean) pose.R = model.pose.R;
  return pose;
}

// Where the noise turns out to be far below the threshold, points with a motion of their own (the outlines of
// things before others) pass as inliers, and bend the motion. A second search at the noise level cannot be
// bent.
Consensus find_finest_consensus(const TwoViews& views, const EpipolarProblem& problem,
                                const RelativePoseOptions& options, const Pose& coarse, double widest) {
  const Consensus first = find_consensus(views, coarse, widest);
  const double fine_error = 2 * first.sigma;
  if (first.members.empty() || !(fine_error < 0.5 * options.max_error)) return first;
  const auto found = ransac(problem, options.ransac, fine_error);
  if (!found) return first;
  const Consensus second = find_consensus(views, pose_of(found->model, views, options), widest);
  if (second.members.empty()) return first;
  const auto cost = [&](const Consensus& c) { return unlikelihood(views, c.refined.pose, widest); };
  return cost(second) < cost(first) ? second : first;
}

void mark_inliers(Estimate& estimate, const EpipolarProblem& problem, const Pose& pose, double max_error) {
  estimate.inliers.assign(problem.size(), 0);
  estimate.num_inliers = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (!(problem.residual(pose, i) < max_error)) continue;
    estimate.inliers[i] = 1;
    ++estimate.num_inliers;
  }
}

}  // namespace

void RelativePoseOptions::check() const {
  ransac.check();
  check_positive(kDoor, "max_error", max_error);
  check_positive(kDoor, "min_inliers", min_inliers);
  check_positive(kDoor, "refinement_error", refinement_error);
  if (solver == RelativePoseSolver::kTwoPoint && !rotation) {
    throw std::invalid_argument(
        "estimate_relative_pose: rotation is missing, expected it for the two-point solver");
  }
}

std::optional<Estimate> estimate_relative_pose(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                               const RelativePoseOptions& options) {
  options.check();
  check_same_size(kDoor, "x1", x1.size(), "x2", x2.size());
  check_bearings(kDoor, "x1", x1);
  check_bearings(kDoor, "x2", x2);
  if (options.solver == RelativePoseSolver::kTwoPoint) {
    return estimate_translation(x1, x2, *options.rotation,
                                {options.ransac, options.max_error, options.min_inliers});
  }
  if (x1.size() < epipolar_sample_size(options.solver)) return std::nullopt;

  const std::vector<Bearing> unit1 = normalized(x1), unit2 = normalized(x2);
  const EpipolarProblem problem(unit1, unit2, options);
  const auto found = ransac(problem, options.ransac, options.max_error);
  if (!found) return std::nullopt;

  Estimate estimate;
  estimate.score = found->tally.cost;
  estimate.iterations = found->iterations;
  estimate.iterations_theory = found->iterations_theory;
  const TwoViews views{unit1, unit2, problem.surface()};
  Pose pose = pose_of(found->model, views, options);
  estimate.cam2_from_cam1 = pose;
  if (options.final_refinement) {
    estimate.kind = EstimateKind::kLowParallax;  // too few agree at the noise level to know more
    const double widest = std::min(options.max_error, options.refinement_error);
    const Consensus consensus = find_finest_consensus(views, problem, options, pose, widest);
    if (!consensus.members.empty()) {
      const Settled settled = settle_minimum(views, consensus, widest);
      const Support support = what_data_support(views, settled);
      estimate.cam2_from_cam1 = support.pose;
      estimate.covariance = support.covariance;
      estimate.kind = support.kind;
      pose = settled.consensus.refined.pose;
    }
  }
  mark_inliers(estimate, problem, pose, options.max_error);
  if (estimate.num_inliers < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  return estimate;
}

}  // namespace framewise
