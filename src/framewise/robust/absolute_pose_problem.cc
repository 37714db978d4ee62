// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/absolute_pose_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/robust/bearings.h"
#include "framewise/solvers/abspose_p3p.h"
#include "framewise/solvers/refine_input.h"

namespace framewise {

AbsolutePoseProblem::AbsolutePoseProblem(std::span<const Eigen::Vector3d> X1, std::span<const Bearing> x2,
                                         double max_error, std::uint64_t seed)
    : X1_(X1), x2_(x2), max_error_(max_error), surface_(surface_of(x2)), columns_(X1.size(), 6, seed) {
  for (std::size_t i = 0; i < X1.size(); ++i) {
    const Eigen::Vector3d x = on_surface("x2", x2[i], surface_);
    for (int k = 0; k < 3; ++k) columns_.set(i, k, X1[i][k]), columns_.set(i, 3 + k, x[k]);
  }
  fill_points_and_rays(points_and_rays_, X1, x2, surface_);
}

void AbsolutePoseProblem::solve(std::span<const std::uint32_t> sample,
                                Hypotheses<Pose, kMaxModels>& models) const {
  for (const Pose& pose : abspose_p3p(gather<3>(x2_, sample), gather<3>(X1_, sample))) models.push_back(pose);
}

Tally AbsolutePoseProblem::score(const Pose& pose, const Judge& judge) const {
  const RowMajor3d R = pose.R;
  return surface_ == ImageSurface::kPlane ? score_projection_plane(columns_, R.data(), pose.t.data(), judge)
                                          : score_projection_sphere(columns_, R.data(), pose.t.data(), judge);
}

bool AbsolutePoseProblem::refine(Pose& pose) const {
  constexpr int kIterations = 6;
  pose = polish(pose, max_error_, {Loss::kTukey, 1.5}, kIterations).pose;
  return true;
}

Refinement AbsolutePoseProblem::polish(const Pose& pose, double sigma, const RobustLoss& loss,
                                       int iterations) const {
  RefineOptions options;
  options.sigma = sigma;
  options.surface = surface_;
  options.loss = loss;
  options.max_iterations = iterations;
  options.tolerance = 1e-4;
  return refine_absolute_pose(pose, points_and_rays_, options);
}

double AbsolutePoseProblem::residual(const Pose& pose, std::size_t i) const {
  const Eigen::Vector3d p = pose * X1_[i];
  if (!(p.dot(x2_[i]) > 0)) return std::numeric_limits<double>::infinity();
  if (surface_ == ImageSurface::kSphere) return p.normalized().cross(x2_[i]).norm();
  return (p.hnormalized() - x2_[i].hnormalized()).norm();
}

double AbsolutePoseProblem::noise_level(const Pose& pose) const {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < size(); ++i) {
    const double r = residual(pose, i);
    if (r < max_error_) residuals.push_back(r);
  }
  if (residuals.empty()) return max_error_;
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  constexpr double kRayleighMedian = 1.1774;  // of the length of two coordinates, in their deviations
  return std::max(*middle / kRayleighMedian, 1e-9);
}

}  // namespace framewise
