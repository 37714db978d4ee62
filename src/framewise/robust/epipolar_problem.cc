// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/epipolar_problem.h"

#include <cmath>
#include <limits>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/triangulation.h"
#include "framewise/robust/bearings.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/refine_input.h"
#include "framewise/solvers/refine_relative_pose.h"

namespace framewise {

EpipolarProblem::EpipolarProblem(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                 const RelativePoseOptions& options)
    : x1_(x1),
      x2_(x2),
      options_(options),
      surface_(common_surface(x1, x2)),
      columns_(x1.size(), 6, options.ransac.seed) {
  const bool on_plane = options.measure == InlierMeasure::kSampson && surface_ == ImageSurface::kPlane;
  const int width = on_plane ? 2 : 3;
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const Eigen::Vector3d a = on_plane ? Eigen::Vector3d(x1[i] / x1[i].z()) : x1[i];
    const Eigen::Vector3d b = on_plane ? Eigen::Vector3d(x2[i] / x2[i].z()) : x2[i];
    for (int k = 0; k < width; ++k) columns_.set(i, k, a[k]), columns_.set(i, width + k, b[k]);
  }
  fill_ray_pairs(ray_pairs_, x1, x2, surface_);
}

Tally EpipolarProblem::score(const Model& model, const Judge& judge) const {
  const RowMajor3d E = model.E, R = model.pose.R;
  switch (options_.measure) {
    case InlierMeasure::kReprojection:
      return score_triangulated(columns_, R.data(), model.pose.t.data(), judge);
    case InlierMeasure::kBearingEuclidean:
      return score_distance(columns_, R.data(), Eigen::Vector3d::Zero().eval().data(), judge);
    case InlierMeasure::kSampson:
      break;
  }
  return surface_ == ImageSurface::kPlane ? score_sampson_plane(columns_, E.data(), judge)
                                          : score_sampson_sphere(columns_, E.data(), judge);
}

bool EpipolarProblem::refine(Model& model) const {
  // The rotation is given, or it alone is judged and the epipolar distance has no part in it.
  if (options_.solver == RelativePoseSolver::kTwoPoint) return false;
  if (options_.measure == InlierMeasure::kBearingEuclidean) return false;
  const bool sampson = options_.measure == InlierMeasure::kSampson;
  RefineOptions refine;
  refine.sigma = options_.max_error;
  refine.surface = surface_;
  refine.loss = {Loss::kTukey, 1.5};  // a little wider than the threshold: the hypothesis is not exact
  refine.max_iterations = 8;
  refine.tolerance = 1e-4;
  model.pose =
      refine_relative_pose(sampson ? decompose_essential(model.E)[0] : model.pose, ray_pairs_, refine).pose;
  model.E = essential_from_pose(model.pose);
  return true;
}

double EpipolarProblem::residual(const Pose& pose, std::size_t i) const {
  const bool plane = surface_ == ImageSurface::kPlane;
  switch (options_.measure) {
    case InlierMeasure::kBearingEuclidean:
      return (x2_[i] - pose.R * x1_[i]).norm();
    case InlierMeasure::kReprojection: {
      const auto point = triangulate_midpoint(pose, x1_[i], x2_[i]);
      if (!point || !point->in_front()) return std::numeric_limits<double>::infinity();
      return std::hypot(point->X1.normalized().cross(x1_[i]).norm(),
                        (pose * point->X1).normalized().cross(x2_[i]).norm());
    }
    case InlierMeasure::kSampson:
      break;
  }
  return std::abs(sampson_residual(pose, plane ? Eigen::Vector3d(x1_[i] / x1_[i].z()) : x1_[i],
                                   plane ? Eigen::Vector3d(x2_[i] / x2_[i].z()) : x2_[i], surface_));
}

}  // namespace framewise
