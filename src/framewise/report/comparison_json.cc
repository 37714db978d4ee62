// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/comparison_json.h"

#include <nlohmann/json.hpp>

namespace framewise {
namespace {

using Object = nlohmann::ordered_json;

Object json_of(const Spread& s) {
  return {{"median", s.median}, {"q1", s.first_quartile}, {"q3", s.third_quartile}, {"count", s.count}};
}
Object json_of(const Interval& interval) { return Object::array({interval.low, interval.high}); }
Object json_of(double value) { return value; }

Object json_of(const PairedDifference& d);
Object json_of(const ComparedErrors& e);
Object json_of(const ComparedTimes& t);
Object json_of(const PublishedResult& p);

template <typename T>
Object json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : Object(nullptr);
}

Object json_of(const PairedDifference& d) {
  return {{"median", d.median},
          {"interval", json_of(d.interval)},
          {"p", d.p},
          {"p_holm", d.p_holm},
          {"real", d.is_real},
          {"frames", d.frames},
          {"flip_block", d.block_length}};
}

Object json_of(const ComparedError& e) {
  return {{"rmse", json_of(e.rmse)},
          {"interval", json_of(e.interval)},
          {"best", e.is_best},
          {"minus_best", json_of(e.to_best)}};
}

Object json_of(const ComparedErrors& e) {
  return {{"alignment", e.alignment},
          {"delta", e.delta},
          {"unit", e.unit},
          {"ate_m", json_of(e.ate)},
          {"rpe_translation_mm", json_of(e.rpe_translation_mm)},
          {"rpe_rotation_deg", json_of(e.rpe_rotation_deg)},
          {"rpe_direction", json_of(e.direction)},
          {"coverage", json_of(e.coverage)}};
}

Object json_of(const ComparedTimes& t) {
  Object rate = nullptr;
  if (t.frames_per_second)
    rate = {{"min", t.frames_per_second->low},
            {"mean", *t.mean_frames_per_second},
            {"max", t.frames_per_second->high}};
  return {{"load_ms", json_of(t.load_ms)},
          {"features_ms", json_of(t.features_ms)},
          {"match_ms", json_of(t.match_ms)},
          {"solve_ms", t.solve_ms},
          {"frames_per_second", rate}};
}

Object json_of(const PublishedResult& p) {
  return {{"ate_m", json_of(p.ate)},
          {"rpe_translation_mm", json_of(p.rpe_translation_mm)},
          {"rpe_rotation_deg", json_of(p.rpe_rotation_deg)},
          {"outcome", p.outcome}};
}

Object json_of(const ComparisonRow& row) {
  Object options = Object::object(), statuses = Object::object();
  for (const auto& [name, value] : row.options) options[name] = value;
  for (const auto& [name, frames] : row.statuses) statuses[name] = json_of(frames);
  const std::string& reason = row.failure.empty() ? row.no_errors : row.failure;
  return {{"dataset", row.dataset},
          {"method", row.method},
          {"features", row.features},
          {"repeats", row.repeats},
          {"failed", row.failed},
          {"reason", reason.empty() ? Object(nullptr) : Object(reason)},
          {"errors", json_of(row.errors)},
          {"measured", json_of(row.measured)},
          {"statuses", statuses},
          {"missing_pairs", json_of(row.missing_pairs)},
          {"published", json_of(row.published)},
          {"times", json_of(row.times)},
          {"options", options},
          {"folder", row.folder}};
}

Object json_of(const ComparedDataset& d) {
  Object static_baseline = nullptr;
  if (d.static_ate)
    static_baseline = {{"ate_m", *d.static_ate},
                       {"rpe_translation_mm", json_of(d.static_rpe_translation_mm)},
                       {"rpe_rotation_deg", json_of(d.static_rpe_rotation_deg)}};
  return {{"name", d.name},
          {"path", d.path},
          {"format", d.format},
          {"fingerprint", d.fingerprint},
          {"frames", d.frames},
          {"frames_with_depth", d.frames_with_depth},
          {"frames_with_truth", d.frames_with_truth},
          {"path_length_m", json_of(d.path_length)},
          {"static_baseline", static_baseline},
          {"folder", d.folder}};
}

Object json_of(const PairedOptions& s) {
  return {{"confidence", s.bootstrap.confidence},
          {"resamples", s.bootstrap.resamples},
          {"flips", s.flips},
          {"significance", s.significance},
          {"correction", "holm"}};
}

}  // namespace

nlohmann::ordered_json to_json(const Comparison& comparison) {
  Object datasets = Object::array(), rows = Object::array();
  for (const ComparedDataset& dataset : comparison.datasets) datasets.push_back(json_of(dataset));
  for (const ComparisonRow& row : comparison.rows) rows.push_back(json_of(row));
  return {{"version", comparison.version},
          {"grid", comparison.grid},
          {"seed", comparison.seed},
          {"repeats", comparison.repeats},
          {"statistics", json_of(comparison.statistics)},
          {"datasets", datasets},
          {"rows", rows}};
}

}  // namespace framewise
