// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "framewise/odometry/step.h"
#include "framewise/robust/estimate.h"

namespace framewise {

// The step an estimate makes: status by its kind, pose, counts and covariance. As it was where there is no
// estimate or too few agree with it.
Step with_estimate(Step step, const std::optional<Estimate>& estimate, int min_inliers);

}  // namespace framewise
