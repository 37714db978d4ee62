// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "framewise/evaluation/evaluation.h"

namespace framewise {

// What one figure counts: an absolute or a relative error, and what of it. The names of the command line:
//   ate, ate-rotation, ate-full, ate-rotation-part, and
//   rpe-translation, rpe-rotation, rpe-full, rpe-rotation-part, rpe-distance, rpe-distance-ratio,
//   rpe-direction.
struct Metric {
  bool relative = false;
  PoseRelation relation = PoseRelation::kTranslation;
};

// Every error with the pose it stands at: an absolute one its own, a relative one the later of its pair.
struct MetricErrors {
  std::vector<double> values;  // m; of angles degrees, of distance ratios per cent, else without unit
  TrajectoryPair poses;        // in the reference's world; stamps of the estimate (s)
};

// Of what evaluate() found. values is empty where no two poses are delta apart. Throws std::invalid_argument
// for a relation that an absolute error does not have.
MetricErrors errors_of(const Evaluation& evaluation, const Metric& metric);

// The other way throws std::invalid_argument listing the names.
std::string name_of(const Metric& metric);
Metric metric_from_name(const std::string& name);

}  // namespace framewise
