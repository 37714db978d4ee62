// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"
#include "framewise/robust/epipolar_solvers.h"
#include "framewise/robust/relative_pose.h"
#include "framewise/robust/scoring.h"
#include "framewise/solvers/point_columns.h"

namespace framewise {

// Two views as ransac() wants them (ransac.h). Unit bearings and options must outlive it.
class EpipolarProblem {
 public:
  using Model = EpipolarModel;
  static constexpr std::size_t kMaxModels = EpipolarModels::capacity();

  EpipolarProblem(std::span<const Bearing> x1, std::span<const Bearing> x2,
                  const RelativePoseOptions& options);

  std::size_t size() const { return x1_.size(); }
  std::size_t sample_size() const { return epipolar_sample_size(options_.solver); }
  void solve(std::span<const std::uint32_t> sample, EpipolarModels& models) const {
    solve_epipolar(options_, x1_, x2_, sample, models);
  }
  Tally score(const Model& model, const Judge& judge) const;
  // Sampson's distance of all correspondences under Tukey's loss.
  bool refine(Model& model) const;

  // The residual that options.measure compares with max_error; infinite behind a camera where that matters.
  double residual(const Pose& pose, std::size_t i) const;
  ImageSurface surface() const { return surface_; }

 private:
  std::span<const Bearing> x1_, x2_;
  const RelativePoseOptions& options_;
  ImageSurface surface_;
  Columns columns_;
  PointColumns ray_pairs_;
};

}  // namespace framewise
