// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "compare_row_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace framewise::apps {
namespace {

double rmse_of(const std::vector<double>& errors, std::span<const std::size_t> frames) {
  double sum = 0;
  for (const std::size_t i : frames) sum += errors[i] * errors[i];
  return std::sqrt(sum / static_cast<double>(frames.size()));
}

// At each frame, of all repeats together.
std::vector<double> mean_over_repeats(const FrameErrors& errors, double power) {
  std::vector<double> means(errors.of_repeats.front().size());
  for (const auto& repeat : errors.of_repeats)
    for (std::size_t i = 0; i < means.size(); ++i)
      means[i] += std::pow(repeat[i], power) / static_cast<double>(errors.of_repeats.size());
  return means;
}

ComparedError compared_error(const FrameErrors& errors, const BootstrapOptions& options) {
  std::vector<std::size_t> all(errors.of_repeats.front().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<double> rmse;
  for (const auto& repeat : errors.of_repeats) rmse.push_back(rmse_of(repeat, all));
  ComparedError compared;
  compared.rmse = spread(rmse);
  compared.interval = bootstrap_interval(
      mean_over_repeats(errors, 2),
      [&](std::span<const std::size_t> frames) { return errors.median_rmse(frames); }, options);
  return compared;
}

// Among the rows that have as many frames as the most have.
void compare_rows(std::span<ComparisonRow> rows, const std::vector<RowErrors>& errors,
                  FrameErrors RowErrors::*frames_of, ComparedError ComparedErrors::*compared,
                  const PairedOptions& options) {
  std::size_t most_frames = 0;
  for (const RowErrors& e : errors)
    if (!e.empty()) most_frames = std::max(most_frames, (e.*frames_of).of_repeats.front().size());
  std::vector<std::size_t> taken;
  std::vector<std::vector<double>> frame_errors;
  std::vector<double> scores;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (errors[i].empty() || (errors[i].*frames_of).of_repeats.front().size() != most_frames) continue;
    taken.push_back(i);
    frame_errors.push_back(mean_over_repeats(errors[i].*frames_of, 1));
    scores.push_back(((*rows[i].errors).*compared).rmse.median);
  }
  if (taken.empty()) return;
  const BestComparison found = compare_with_best(frame_errors, scores, options);
  for (std::size_t k = 0; k < taken.size(); ++k) {
    ComparedError& error = (*rows[taken[k]].errors).*compared;
    error.is_best = k == found.best;
    error.to_best = found.differences[k];
  }
}

}  // namespace

double FrameErrors::median_rmse(std::span<const std::size_t> frames) const {
  std::vector<double> rmse;
  for (const auto& repeat : of_repeats) rmse.push_back(rmse_of(repeat, frames));
  return median(rmse);
}

void RowErrors::add(const Trajectory& truth, const Trajectory& estimate, const std::string& alignment_name) {
  EvaluationOptions options;
  options.association.max_difference = 1e-6;  // the truth is at the frames' own times
  options.alignment = alignment_from_name(alignment_name);
  const Evaluation e = evaluate(truth, estimate, options);
  if (!e.rpe) return;
  alignment = alignment_name;
  delta = e.options.relative.delta;
  unit = name_of(e.options.relative.unit);
  ate.push_back(e.ate.rmse);
  direction.push_back(e.rpe->direction.rmse);
  coverage.push_back(e.coverage);
  const auto add_frames = [&](FrameErrors& frames, PoseRelation relation, double factor) {
    std::vector<double> errors = relative_errors(e.motions, relation, e.options.relative.resolved_order());
    for (double& error : errors) error *= factor;
    frames.of_repeats.push_back(std::move(errors));
  };
  add_frames(translation_mm, PoseRelation::kTranslation, 1e3);
  add_frames(rotation_deg, PoseRelation::kRotationAngle, 180 / std::numbers::pi);
}

void summarise_errors(std::span<ComparisonRow> rows, const std::vector<RowErrors>& errors,
                      const PairedOptions& options) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RowErrors& e = errors[i];
    if (e.empty()) continue;
    rows[i].errors = ComparedErrors{e.alignment,
                                    e.delta,
                                    e.unit,
                                    spread(e.ate),
                                    spread(e.direction),
                                    spread(e.coverage),
                                    compared_error(e.translation_mm, options.bootstrap),
                                    compared_error(e.rotation_deg, options.bootstrap)};
  }
  compare_rows(rows, errors, &RowErrors::translation_mm, &ComparedErrors::rpe_translation_mm, options);
  compare_rows(rows, errors, &RowErrors::rotation_deg, &ComparedErrors::rpe_rotation_deg, options);
}

}  // namespace framewise::apps
