// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "framewise/geometry/camera.h"
#include "framewise/geometry/correspondences.h"
#include "framewise/odometry/options.h"
#include "framewise/odometry/status.h"

namespace framewise {

// The motion between two frames.
struct Step {
  Status status = Status::kLost;
  Pose cam2_from_cam1;           // only where is_measured(status)
  int matches = 0;               // correspondences given
  int inliers = 0;               // of those, the ones that agree with the motion
  int iterations = 0;            // of RANSAC
  double iterations_theory = 0;  // that the share of inliers asks for (ransac_iterations.h)
  // Of the tangent vector (rotation, translation) of cam2_from_cam1, R exp(rotation) and t + translation, in
  // rad and the unit of t, under the noise that the inliers show or the sensors are said to have. NaN where
  // it is not known: all of it where no motion was measured or nothing was checked (ransac two-stage and
  // off), translation's part where the camera only turned and where it came from centroids. A step from
  // bearings has rank 5, with nothing along t: what its length is worth is not told.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<std::uint8_t> inlier_mask;  // 1 for each correspondence that agrees; empty where none was found
  // Where surfaces were aligned (geometric_refinement.h): the motions they do not resist, along which the
  // step was foretold, and the share of the frame that fits.
  std::vector<std::string> free_directions;
  double overlap = std::numeric_limits<double>::quiet_NaN();
  // What depth says of the length of t, which is 1 (m): only for scale first-pair, where there is depth.
  std::optional<double> length_from_depth;
};

// What is known of a step before it is estimated.
struct StepKnowledge {
  std::optional<double> true_length = {};        // m, for scale truth; without it such a step is lost
  std::optional<Eigen::Matrix3d> rotation = {};  // cam2_from_cam1, for two-point; likewise
};

// The motion that explains the correspondences of two frames, by options.solver.
Step estimate_step(const Correspondences& correspondences, const Camera& camera,
                   const OdometryOptions& options, std::uint64_t seed, const StepKnowledge& known = {});

}  // namespace framewise
