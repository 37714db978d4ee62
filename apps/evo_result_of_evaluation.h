// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/evaluation/metric.h"
#include "framewise/io/evo_result.h"

namespace framewise::apps {

// One metric of an evaluation as evo keeps it; the names of the trajectories are left to the caller. Throws
// std::invalid_argument where there is no such error: no two poses are delta apart.
EvoResult evo_result(const Evaluation& evaluation, const Metric& metric);

}  // namespace framewise::apps
