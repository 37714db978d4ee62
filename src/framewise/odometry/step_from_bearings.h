// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/odometry/step.h"

namespace framewise {

// A step whose rotation and direction come from bearings by options.solver and whose length comes from
// options.scale (scale.h). `step` carries the number of matches.
Step step_from_bearings(Step step, const Correspondences& shared, const Camera& camera,
                        const OdometryOptions& options, std::uint64_t seed, const StepKnowledge& known);

}  // namespace framewise
