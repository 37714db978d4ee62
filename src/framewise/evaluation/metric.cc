// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/metric.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace framewise {
namespace {

struct NamedMetric {
  const char* name;
  Metric metric;
};

constexpr std::array named_metrics = {
    NamedMetric{"ate", {false, PoseRelation::kTranslation}},
    NamedMetric{"ate-rotation", {false, PoseRelation::kRotationAngle}},
    NamedMetric{"ate-full", {false, PoseRelation::kFull}},
    NamedMetric{"ate-rotation-part", {false, PoseRelation::kRotationPart}},
    NamedMetric{"rpe-translation", {true, PoseRelation::kTranslation}},
    NamedMetric{"rpe-rotation", {true, PoseRelation::kRotationAngle}},
    NamedMetric{"rpe-full", {true, PoseRelation::kFull}},
    NamedMetric{"rpe-rotation-part", {true, PoseRelation::kRotationPart}},
    NamedMetric{"rpe-distance", {true, PoseRelation::kPointDistance}},
    NamedMetric{"rpe-distance-ratio", {true, PoseRelation::kPointDistanceRatio}},
    NamedMetric{"rpe-direction", {true, PoseRelation::kDirection}}};

double unit_of(PoseRelation relation) {
  if (relation == PoseRelation::kRotationAngle) return 180 / M_PI;
  return relation == PoseRelation::kPointDistanceRatio ? 100 : 1;
}

// Where relative errors stand; ratios to a step of length zero do not exist.
TrajectoryPair ends_of(const std::vector<RelativeMotion>& motions, PoseRelation relation) {
  TrajectoryPair ends;
  for (const RelativeMotion& motion : motions) {
    if (relation == PoseRelation::kPointDistanceRatio && !(motion.reference_distance > 0)) continue;
    ends.reference.add(motion.to_time, motion.reference_at_end);
    ends.estimate.add(motion.to_time, motion.estimate_at_end);
  }
  return ends;
}

}  // namespace

MetricErrors errors_of(const Evaluation& evaluation, const Metric& metric) {
  MetricErrors errors;
  if (metric.relative) {
    errors.values =
        relative_errors(evaluation.motions, metric.relation, evaluation.options.relative.resolved_order());
    errors.poses = ends_of(evaluation.motions, metric.relation);
  } else {
    errors.values = absolute_errors(evaluation.poses, metric.relation);
    errors.poses = evaluation.poses;
    errors.poses.reference.times = evaluation.poses.estimate.times;
  }
  for (double& value : errors.values) value *= unit_of(metric.relation);
  return errors;
}

std::string name_of(const Metric& metric) {
  for (const auto& [name, named] : named_metrics)
    if (named.relative == metric.relative && named.relation == metric.relation) return name;
  return "ate";  // the distance of the positions, as kTranslation
}

Metric metric_from_name(const std::string& name) {
  std::string expected;
  for (const NamedMetric& named : named_metrics) {
    if (named.name == name) return named.metric;
    expected += std::string(" ") + named.name;
  }
  throw std::invalid_argument("metric is '" + name + "', expected one of" + expected);
}

}  // namespace framewise
