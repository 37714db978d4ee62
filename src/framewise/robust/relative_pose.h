// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "framewise/robust/estimate.h"
#include "framewise/robust/ransac_options.h"

namespace framewise {

enum class RelativePoseSolver {
  kEightPoint,
  kSevenPoint,
  kNister5pt,
  kStewenius5pt,
  kKneip5ptRotation,  // the translation of each rotation from the same five bearings
  kEigensolver,       // on ten bearings
  kTwoPoint           // the rotation is known: RelativePoseOptions::rotation
};

// What makes a correspondence an inlier: its residual below max_error.
enum class InlierMeasure {
  kSampson,          // first-order distance to the epipolar constraint
  kReprojection,     // both bearings against the point midway between their rays, in front of both cameras
  kBearingEuclidean  // |x2 - R x1|: the translation is taken for small
};

struct RelativePoseOptions {
  RansacOptions ransac;
  RelativePoseSolver solver = RelativePoseSolver::kNister5pt;
  InlierMeasure measure = InlierMeasure::kSampson;
  double max_error = 2.0 / 525;             // of an inlier: pixels / focal length, or rad
  int min_inliers = 12;                     // fewer are no answer
  std::optional<Eigen::Matrix3d> rotation;  // cam2_from_cam1, for the two-point solver
  // Sampson's distance that the final refinement starts from; the inlier measure may be far coarser.
  double refinement_error = 2.0 / 525;
  bool final_refinement = true;  // least squares on all inliers at the noise they show
  // Throws std::invalid_argument naming the field that makes no sense.
  void check() const;
};

// Motion between two calibrated views from corresponding bearings (of any length), some of them wrong:
//   lambda2 x2 = R (lambda1 x1) + t,  |t| = 1.
// Estimate::kind says what the data support (degeneracy.h). Where that is kRotationOnly, t is 0 and its
// covariance NaN. Errors are measured on the plane z = 1, as a pinhole's pixels are, unless a bearing is 80
// degrees off the axis or more: then on the sphere.
// Empty: fewer points than the solver needs, or too few inliers. Throws std::invalid_argument on sizes that
// differ, on numbers that are not finite and on bearings of length zero.
std::optional<Estimate> estimate_relative_pose(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                               const RelativePoseOptions& options = {});

}  // namespace framewise
