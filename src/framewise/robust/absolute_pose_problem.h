// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"
#include "framewise/robust/scoring.h"
#include "framewise/solvers/hypotheses.h"
#include "framewise/solvers/point_columns.h"
#include "framewise/solvers/refine_absolute_pose.h"

namespace framewise {

// Points of camera 1 and the unit bearings x2 that see them, as ransac() wants them (ransac.h): P3P, judged
// by reprojection. The spans must outlive it.
class AbsolutePoseProblem {
 public:
  using Model = Pose;
  static constexpr std::size_t kMaxModels = 4;

  AbsolutePoseProblem(std::span<const Eigen::Vector3d> X1, std::span<const Bearing> x2, double max_error,
                      std::uint64_t seed);

  std::size_t size() const { return X1_.size(); }
  std::size_t sample_size() const { return 3; }
  void solve(std::span<const std::uint32_t> sample, Hypotheses<Pose, kMaxModels>& models) const;
  Tally score(const Pose& pose, const Judge& judge) const;
  bool refine(Pose& pose) const;

  // Least squares on all correspondences under a loss.
  Refinement polish(const Pose& pose, double sigma, const RobustLoss& loss, int iterations) const;
  // Reprojection error in camera 2; infinite behind it.
  double residual(const Pose& pose, std::size_t i) const;
  // Standard deviation of a coordinate, from the median of the residuals within the threshold.
  double noise_level(const Pose& pose) const;
  ImageSurface surface() const { return surface_; }

 private:
  std::span<const Eigen::Vector3d> X1_;
  std::span<const Bearing> x2_;
  double max_error_;
  ImageSurface surface_;
  Columns columns_;
  PointColumns points_and_rays_;
};

}  // namespace framewise
