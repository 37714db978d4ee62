// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/rgbd_pose.h"

#include <cmath>
#include <string>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/robust/absolute_pose_problem.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/correspondences_check.h"
#include "framewise/robust/ransac.h"
#include "framewise/solvers/refine_rgbd_pair.h"

namespace framewise {
namespace {

constexpr char kDoor[] = "estimate_rgbd_pose";

bool has_depth(double z) { return z > 0; }

// Those correspondences that camera 1 has a depth for.
struct KnownPoints {
  std::vector<Eigen::Vector3d> X1;
  std::vector<Bearing> x2;
};

KnownPoints known_points(std::span<const Bearing> x1, std::span<const double> z1,
                         std::span<const Bearing> x2) {
  KnownPoints known;
  known.X1.reserve(x1.size()), known.x2.reserve(x1.size());
  for (std::size_t i = 0; i < x1.size(); ++i) {
    if (!has_depth(z1[i])) continue;
    known.X1.push_back(point_at_depth(x1[i], z1[i]));
    known.x2.push_back(x2[i].normalized());
  }
  return known;
}

double reprojection_error(const Pose& pose, const Eigen::Vector3d& X, const Bearing& x) {
  const Eigen::Vector3d p = pose * X;
  return p.z() > 0 ? (p.hnormalized() - x.hnormalized()).norm() : INFINITY;
}

// By the depth of camera 1, else by that of camera 2, else by the epipolar line.
double error(const Pose& pose, const Bearing& x1, double z1, const Bearing& x2, double z2) {
  if (has_depth(z1)) return reprojection_error(pose, point_at_depth(x1, z1), x2);
  if (has_depth(z2)) return reprojection_error(pose.inverse(), point_at_depth(x2, z2), x1);
  return std::abs(sampson_residual(pose, x1 / x1.z(), x2 / x2.z(), ImageSurface::kPlane));
}

}  // namespace

void RgbdPoseOptions::check() const {
  ransac.check();
  check_positive(kDoor, "max_error", max_error);
  check_positive(kDoor, "min_inliers", min_inliers);
  if (image_sigma) check_positive(kDoor, "image_sigma", *image_sigma);
  depth_noise.check();
}

std::optional<Estimate> estimate_rgbd_pose(std::span<const Bearing> x1, std::span<const double> z1,
                                           std::span<const Bearing> x2, std::span<const double> z2,
                                           const RgbdPoseOptions& options) {
  options.check();
  check_same_size(kDoor, "x1", x1.size(), "z1", z1.size());
  check_same_size(kDoor, "x1", x1.size(), "x2", x2.size());
  check_same_size(kDoor, "x1", x1.size(), "z2", z2.size());
  check_forward(kDoor, "x1", x1);
  check_forward(kDoor, "x2", x2);
  check_depths(kDoor, "z1", z1);
  check_depths(kDoor, "z2", z2);

  const KnownPoints known = known_points(x1, z1, x2);
  if (known.X1.size() < 4) return std::nullopt;
  AbsolutePoseProblem problem(known.X1, known.x2, options.max_error, options.ransac.seed);
  const auto found = ransac(problem, options.ransac, options.max_error);
  if (!found) return std::nullopt;

  const auto inliers_of = [&](const Pose& pose, double limit) {
    std::vector<std::uint32_t> members;
    for (std::uint32_t i = 0; i < x1.size(); ++i) {
      if (error(pose, x1[i], z1[i], x2[i], z2[i]) < limit) members.push_back(i);
    }
    return members;
  };
  std::vector<std::uint32_t> members = inliers_of(found->model, options.max_error);
  if (members.size() < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  RefineOptions refine;
  // A reprojection has the noise of both images.
  refine.sigma = options.image_sigma.value_or(problem.noise_level(found->model) / std::sqrt(2.0));
  refine.loss = {Loss::kTukey, 8};  // 95 % efficient for residuals of three coordinates
  refine.max_iterations = 10;
  refine.tolerance = 1e-3;
  RgbdColumns columns;
  fill_rgbd_pair(columns, x1, z1, x2, z2, options.depth_noise, refine.sigma, members);
  const Refinement refined = refine_rgbd_pair(found->model, columns, refine);

  Estimate estimate;
  estimate.cam2_from_cam1 = refined.pose;
  estimate.covariance = refined.covariance;
  estimate.inliers.assign(x1.size(), 0);
  members = inliers_of(refined.pose, options.max_error);
  for (const std::uint32_t i : members) estimate.inliers[i] = 1;
  estimate.num_inliers = members.size();
  if (members.size() < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
  Judge judge;
  judge.max_error = options.max_error;
  judge.scoring = options.ransac.scoring;
  estimate.score = problem.score(refined.pose, judge).cost;
  estimate.iterations = found->iterations;
  estimate.iterations_theory = found->iterations_theory;
  return estimate;
}

}  // namespace framewise
