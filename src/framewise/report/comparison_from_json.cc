// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "framewise/report/comparison_json.h"

namespace framewise {
namespace {

using Record = nlohmann::ordered_json;

template <typename T, typename Read>
std::optional<T> unless_null(const Record& json, Read&& read) {
  if (json.is_null()) return std::nullopt;
  return read(json);
}

std::optional<double> number_in(const Record& json, const char* name) {
  return unless_null<double>(json.at(name), [](const Record& value) { return value.get<double>(); });
}

// Empty for null.
std::string text_in(const Record& json, const char* name) {
  const Record& value = json.at(name);
  return value.is_null() ? "" : value.get<std::string>();
}

Spread spread_in(const Record& json) {
  return {json.at("median").get<double>(), json.at("q1").get<double>(), json.at("q3").get<double>(),
          json.at("count").get<std::size_t>()};
}

std::optional<Interval> interval_in(const Record& json) {
  return unless_null<Interval>(json, [](const Record& ends) {
    return Interval{ends.at(0).get<double>(), ends.at(1).get<double>()};
  });
}

PairedDifference difference_in(const Record& json) {
  PairedDifference d;
  d.median = json.at("median").get<double>();
  d.interval = interval_in(json.at("interval"));
  d.p = json.at("p").get<double>();
  d.p_holm = json.at("p_holm").get<double>();
  d.is_real = json.at("real").get<bool>();
  d.frames = json.at("frames").get<std::size_t>();
  d.block_length = json.at("flip_block").get<std::size_t>();
  return d;
}

ComparedError error_in(const Record& json) {
  return {spread_in(json.at("rmse")), interval_in(json.at("interval")), json.at("best").get<bool>(),
          unless_null<PairedDifference>(json.at("minus_best"), difference_in)};
}

ComparedErrors errors_in(const Record& json) {
  ComparedErrors e;
  e.alignment = text_in(json, "alignment");
  e.delta = json.at("delta").get<double>();
  e.unit = text_in(json, "unit");
  e.ate = spread_in(json.at("ate_m"));
  e.direction = spread_in(json.at("rpe_direction"));
  e.coverage = spread_in(json.at("coverage"));
  e.rpe_translation_mm = error_in(json.at("rpe_translation_mm"));
  e.rpe_rotation_deg = error_in(json.at("rpe_rotation_deg"));
  return e;
}

ComparedTimes times_in(const Record& json) {
  ComparedTimes t;
  t.load_ms = number_in(json, "load_ms");
  t.features_ms = number_in(json, "features_ms");
  t.match_ms = number_in(json, "match_ms");
  t.solve_ms = json.at("solve_ms").get<double>();
  const Record& rate = json.at("frames_per_second");
  if (rate.is_null()) return t;
  t.frames_per_second = Interval{rate.at("min").get<double>(), rate.at("max").get<double>()};
  t.mean_frames_per_second = rate.at("mean").get<double>();
  return t;
}

PublishedResult published_in(const Record& json) {
  return {number_in(json, "ate_m"), number_in(json, "rpe_translation_mm"),
          number_in(json, "rpe_rotation_deg"), text_in(json, "outcome")};
}

ComparisonRow row_in(const Record& json) {
  ComparisonRow row;
  row.dataset = text_in(json, "dataset");
  row.method = text_in(json, "method");
  row.features = text_in(json, "features");
  row.folder = json.value("folder", "");
  row.repeats = json.at("repeats").get<std::size_t>();
  row.failed = json.at("failed").get<std::size_t>();
  (row.failed > 0 ? row.failure : row.no_errors) = text_in(json, "reason");
  row.errors = unless_null<ComparedErrors>(json.at("errors"), errors_in);
  row.measured = unless_null<Spread>(json.at("measured"), spread_in);
  for (const auto& [name, frames] : json.at("statuses").items())
    row.statuses.emplace_back(name, spread_in(frames));
  row.missing_pairs = unless_null<Spread>(json.at("missing_pairs"), spread_in);
  row.times = unless_null<ComparedTimes>(json.at("times"), times_in);
  row.published = unless_null<PublishedResult>(json.at("published"), published_in);
  for (const auto& [name, value] : json.at("options").items())
    row.options.emplace_back(name, value.get<std::string>());
  return row;
}

ComparedDataset dataset_in(const Record& json) {
  ComparedDataset d;
  d.name = text_in(json, "name");
  d.path = text_in(json, "path");
  d.format = text_in(json, "format");
  d.fingerprint = text_in(json, "fingerprint");
  d.folder = json.value("folder", "");
  d.frames = json.at("frames").get<std::size_t>();
  d.frames_with_depth = json.at("frames_with_depth").get<std::size_t>();
  d.frames_with_truth = json.at("frames_with_truth").get<std::size_t>();
  d.path_length = number_in(json, "path_length_m");
  const Record& still = json.at("static_baseline");
  if (still.is_null()) return d;
  d.static_ate = number_in(still, "ate_m");
  d.static_rpe_translation_mm = number_in(still, "rpe_translation_mm");
  d.static_rpe_rotation_deg = number_in(still, "rpe_rotation_deg");
  return d;
}

PairedOptions statistics_in(const Record& json) {
  PairedOptions s;
  s.bootstrap.confidence = json.at("confidence").get<double>();
  s.bootstrap.resamples = json.at("resamples").get<decltype(s.bootstrap.resamples)>();
  s.flips = json.at("flips").get<int>();
  s.significance = json.at("significance").get<double>();
  return s;
}

}  // namespace

Comparison comparison_from_json(const nlohmann::ordered_json& json) {
  Comparison comparison;
  comparison.version = text_in(json, "version");
  comparison.grid = text_in(json, "grid");
  comparison.seed = json.at("seed").get<std::uint64_t>();
  comparison.repeats = json.at("repeats").get<std::size_t>();
  comparison.statistics = statistics_in(json.at("statistics"));
  comparison.statistics.bootstrap.seed = comparison.seed;
  for (const Record& dataset : json.at("datasets")) comparison.datasets.push_back(dataset_in(dataset));
  for (const Record& row : json.at("rows")) comparison.rows.push_back(row_in(row));
  for (const ComparisonRow& row : comparison.rows) comparison.has_published |= row.published.has_value();
  return comparison;
}

}  // namespace framewise
