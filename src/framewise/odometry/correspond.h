// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/geometry/camera.h"
#include "framewise/geometry/correspondences.h"
#include "framewise/odometry/observation.h"
#include "framewise/odometry/options.h"

namespace framewise {

// What two observations both saw: matches their features, places each match in frame 2 to fractions of a
// pixel, and looks up bearing and depth there. Of the options, those that shape features and matches are
// used, and the seed where the matcher is flann; solver, scale, error and thresholds are not. Everything that
// depends on pixels happens here: estimate_step (step.h) needs no images.
Correspondences correspond(const Observation& frame1, const Observation& frame2, const Camera& camera,
                           const OdometryOptions& options);

}  // namespace framewise
