// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/odometry/step.h"

namespace framewise {

// A metric step from correspondences with depth, by options.solver: kabsch (points of both cameras on each
// other, robust/registration.h) or p3p (points of camera 1 on what camera 2 sees, robust/rgbd_pose.h).
// `step` carries the number of matches.
Step step_from_points(Step step, const Correspondences& shared, const Camera& camera,
                      const OdometryOptions& options, std::uint64_t seed);

}  // namespace framewise
