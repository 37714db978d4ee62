// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evo_result_of_evaluation.h"

#include <fmt/format.h>

#include "framewise/report/evo_labels.h"

namespace framewise::apps {
namespace {

void add_pose(EvoResult& result, const TrajectoryPair& poses, std::size_t i) {
  const double time = poses.estimate.times[i];
  result.reference.add(time, poses.reference.world_from_cam[i]);
  result.estimate.add(time, poses.estimate.world_from_cam[i]);
}

Eigen::Matrix4d matrix_of(const Similarity& similarity) {
  Eigen::Matrix4d M = similarity.pose.matrix();
  M.topLeftCorner<3, 3>() *= similarity.scale;
  return M;
}

}  // namespace

EvoResult evo_result(const Evaluation& evaluation, const Metric& metric) {
  const MetricErrors errors = errors_of(evaluation, metric);
  if (errors.values.empty())
    throw std::invalid_argument(
        fmt::format("metric: found '{}', of which there is none: no two poses are delta apart, expected a "
                    "smaller delta",
                    name_of(metric)));
  EvoResult result;
  const EvoLabels labels = evo_labels(evaluation, metric);
  result.title = labels.title;
  result.label = labels.label;
  const Statistics s = statistics(errors.values);
  result.statistics = {{"rmse", s.rmse}, {"mean", s.mean}, {"median", s.median}, {"std", s.std},
                       {"min", s.min},   {"max", s.max},   {"sse", s.sse}};
  result.errors = errors.values;
  if (metric.relative) add_pose(result, evaluation.poses, 0);
  for (std::size_t i = 0; i < errors.poses.size(); ++i) add_pose(result, errors.poses, i);
  if (evaluation.options.alignment != Alignment::kNone)
    result.alignment = matrix_of(evaluation.reference_from_estimate);
  return result;
}

}  // namespace framewise::apps
