// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "framewise/geometry/pose.h"
#include "framewise/registration/surface_pyramid.h"
#include "framewise/solvers/robust_loss.h"

namespace framewise {

struct AlignmentOptions {
  // Gauss-Newton steps at most, finest level first; a level without an entry takes the last.
  std::array<int, 4> iterations{6, 8, 10, 10};
  int skipped_rows = 0;              // of the finest level, between two that are used
  RobustLoss loss{Loss::kTukey, 4};  // of a point's distance from its plane (standard deviations)
  double widening = 2;               // a level's standard deviations over the next finer one's
  double depth_gate = 0.1;           // points whose depths differ by more (a share) are of two surfaces
  double normal_gate = 0.9;          // and those whose normals have a smaller cosine (26 deg)
  // So many pixels of the finest level share their noise: a structured-light camera finds depth by comparing
  // windows, and rounds it. Only the covariance depends on it.
  double noise_area_px = 8;
  // A direction is free where the information about it is less than so many times what noise in the normals
  // feigns.
  double least_information = 3;
  double least_inliers = 300;  // pixels of the finest level; fewer say nothing

  // Throws std::invalid_argument that names the value.
  void check() const;
};

// A motion that the surfaces do not resist: about `centre`, rotation (rad) and translation (m) in the
// reference's axes, scaled so that it moves the surfaces by about 1 m.
struct FreeDirection {
  Eigen::Vector3d rotation, translation, centre;

  bool is_translation() const { return translation.squaredNorm() > 0.5; }
};
std::string name_of(const FreeDirection& direction);  // "translation along (1.00, 0.00, 0.00)"

struct SurfaceAlignment {
  Pose cam2_from_cam1;  // 1: the reference, 2: the current surface
  // Of its tangent vector (rotation, translation), R exp(rotation) and t + translation; NaN where a direction
  // is free.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  // Of the motion exp(omega) x + tau of x_in_cam1, (omega, tau): J' J over sigma^2 as counted.
  Matrix6d information = Matrix6d::Zero();
  std::vector<FreeDirection> free_directions;  // along these the guess was kept
  double overlap = 0;                          // share of the current surface that fits the reference
  double rms = 0;                              // of its residuals (standard deviations)
  int iterations = 0;
};

// The motion between two surfaces, from a guess that is good to a few pixels of the coarsest level: point to
// plane with projective association (alignment_kernels.h), coarse to fine, each point weighed by its noise.
// Directions that the geometry leaves free are those whose eigenvalues of the information do not rise above
// what noise feigns; no step is taken along them:
//   Zhang, Kaess, Singh, On degeneracy of optimization-based state estimation problems, ICRA 2016.
// Empty where too few points find a partner.
std::optional<SurfaceAlignment> align_surfaces(const SurfacePyramid& reference, const SurfacePyramid& current,
                                               const Pose& cam2_from_cam1_guess,
                                               const AlignmentOptions& options);

// How many pixels of a coarse level fit under a motion, for the choice between guesses.
double fitting_pixels(const SurfacePyramid& reference, const SurfacePyramid& current,
                      const Pose& cam2_from_cam1, const AlignmentOptions& options);

}  // namespace framewise
