// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/absolute_pose.h"

#include "framewise/robust/absolute_pose_problem.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/ransac.h"

namespace framewise {
namespace {

constexpr char kDoor[] = "estimate_absolute_pose";

}  // namespace

void AbsolutePoseOptions::check() const {
  ransac.check();
  check_positive(kDoor, "max_error", max_error);
  check_positive(kDoor, "min_inliers", min_inliers);
}

std::optional<Estimate> estimate_absolute_pose(std::span<const Eigen::Vector3d> X1,
                                               std::span<const Bearing> x2,
                                               const AbsolutePoseOptions& options) {
  options.check();
  check_same_size(kDoor, "X1", X1.size(), "x2", x2.size());
  check_points(kDoor, "X1", X1);
  check_bearings(kDoor, "x2", x2);
  if (X1.size() < 4) return std::nullopt;

  const std::vector<Bearing> unit2 = normalized(x2);
  AbsolutePoseProblem problem(X1, unit2, options.max_error, options.ransac.seed);
  const auto found = ransac(problem, options.ransac, options.max_error);
  if (!found) return std::nullopt;
  // At the noise that the inliers show, Tukey's loss is 95 % efficient.
  constexpr double kTukeyCut = 4.685;
  const Refinement refined =
      problem.polish(found->model, problem.noise_level(found->model), {Loss::kTukey, kTukeyCut}, 10);

  Estimate estimate;
  estimate.cam2_from_cam1 = refined.pose;
  estimate.covariance = refined.covariance;
  estimate.inliers.resize(X1.size());
  for (std::size_t i = 0; i < X1.size(); ++i) {
    estimate.inliers[i] = problem.residual(refined.pose, i) < options.max_error;
    estimate.num_inliers += estimate.inliers[i];
  }
  if (estimate.num_inliers < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  Judge judge;
  judge.max_error = options.max_error;
  judge.scoring = options.ransac.scoring;
  estimate.score = problem.score(refined.pose, judge).cost;
  estimate.iterations = found->iterations;
  estimate.iterations_theory = found->iterations_theory;
  return estimate;
}

}  // namespace framewise
