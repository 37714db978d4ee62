// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/geometry/camera.h"
#include "framewise/odometry/observation.h"
#include "framewise/odometry/options.h"
#include "framewise/odometry/status.h"

namespace framewise {

// The motion between two frames.
struct Step {
  Status status = Status::kLost;
  Pose cam2_from_cam1;           // only where is_measured(status)
  int matches = 0;               // pairs of features that chose each other
  int inliers = 0;               // of those, pairs that agree with the motion
  int iterations = 0;            // of RANSAC
  double iterations_theory = 0;  // that the share of inliers asks for (ransac_iterations.h)
};

// Matches two observations and estimates the motion between them. Where the scale comes from the truth,
// true_length is the length of the true step (m); without it such a step is lost.
Step estimate_step(const Observation& frame1, const Observation& frame2, const Camera& camera,
                   const OdometryOptions& options, std::uint64_t seed, std::optional<double> true_length);

}  // namespace framewise
