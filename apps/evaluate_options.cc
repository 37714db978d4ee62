// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_options.h"

#include <fmt/format.h>

#include <map>

#include "framewise/evaluation/presets.h"

namespace framewise::apps {
namespace {

template <typename T>
T choose(const char* option, const std::string& found, const std::map<std::string, T>& known) {
  if (const auto choice = known.find(found); choice != known.end()) return choice->second;
  std::string expected;
  for (const auto& [name, value] : known) expected += (expected.empty() ? "" : ", ") + name;
  throw std::invalid_argument(fmt::format("{}: found '{}', expected one of {}", option, found, expected));
}

const std::map<std::string, AssociationMethod> associations = {
    {"nearest", AssociationMethod::kNearest},
    {"greedy", AssociationMethod::kGreedy},
    {"interpolated", AssociationMethod::kInterpolated},
    {"index", AssociationMethod::kIndex}};
const std::map<std::string, PairChoice> pair_choices = {
    {"consecutive", PairChoice::kConsecutive}, {"all", PairChoice::kAll}, {"tum", PairChoice::kTum}};
const std::map<std::string, Plane> planes = {{"xy", Plane::kXy}, {"xz", Plane::kXz}, {"yz", Plane::kYz}};

void add_matching_options(CLI::App& app, EvaluateOptions& options) {
  app.add_option(
      "--association", options.association,
      "nearest (default, evo), greedy (TUM tools), interpolated (truth moved to the estimate's times) or "
      "index");
  app.add_option("--max-difference", options.max_difference,
                 "largest time difference of a match (s, default 0.01)");
  app.add_option("--time-offset", options.time_offset, "added to the estimate's times (s, default 0)");
  app.add_option("--from-time", options.from_time, "only the reference's poses from this time on count (s)");
  app.add_option("--to-time", options.to_time, "only the reference's poses up to this time count (s)");
}

void add_alignment_options(CLI::App& app, EvaluateOptions& options) {
  app.add_option("--align", options.align, "none, se3 (default), sim3, scale, yaw or origin");
  app.add_option("--poses-to-align", options.poses_to_align,
                 "align by the first so many matched poses (default 0: all)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--estimate-scale", options.estimate_scale,
                 "the estimate's positions are multiplied by this first (default 1)");
  app.add_option("--plane", options.plane, "xy, xz or yz: both are projected onto it after alignment");
}

void add_relative_options(CLI::App& app, EvaluateOptions& options) {
  app.add_option("--delta", options.delta, "span of the relative error (default 1)");
  app.add_option("--unit", options.unit, "of delta: frames (default), seconds, metres, degrees or radians");
  app.add_option(
      "--pairs", options.pairs,
      "consecutive (evo's default), all (evo's --all_pairs) or tum (their --fixed_delta; the default for "
      "seconds)");
  app.add_option("--tolerance", options.tolerance,
                 "of delta, that all pairs may be away from it (default 0.1; not for frames)");
  app.add_flag("--from-first-pose", options.from_first_pose,
               "consecutive metres are counted from the first pose, as evo does from 1.38 on, not from where "
               "delta is first reached");
  app.add_flag("--pairs-from-reference", options.pairs_from_reference,
               "pairs are chosen on the reference, not on the estimate");
}

void resolve_matching(const EvaluateOptions& typed, EvaluationOptions& options) {
  AssociationOptions& association = options.association;
  if (!typed.association.empty()) association.method = choose("association", typed.association, associations);
  association.max_difference = typed.max_difference.value_or(association.max_difference);
  association.time_offset = typed.time_offset.value_or(association.time_offset);
  options.from_time = typed.from_time.value_or(options.from_time);
  options.to_time = typed.to_time.value_or(options.to_time);
}

void resolve_relative(const EvaluateOptions& typed, RelativeErrorOptions& relative) {
  if (!typed.unit.empty()) {
    relative.unit = delta_unit_from_name(typed.unit);
    relative.pairs.reset();  // what suits the unit
  }
  if (!typed.pairs.empty()) relative.pairs = choose("pairs", typed.pairs, pair_choices);
  relative.delta = typed.delta.value_or(relative.delta);
  relative.tolerance = typed.tolerance.value_or(relative.tolerance);
  relative.from_first_pose |= typed.from_first_pose;
  relative.pairs_from_reference |= typed.pairs_from_reference;
}

}  // namespace

void EvaluateOptions::add_to(CLI::App& app) {
  app.add_option("--preset", preset,
                 "settings of another tool: evo, tum, kitti or lab; options given beside it win");
  add_alignment_options(app, *this);
  add_relative_options(app, *this);
  add_matching_options(app, *this);
}

EvaluationOptions EvaluateOptions::resolved() const {
  EvaluationOptions options = preset.empty() ? EvaluationOptions{} : evaluation_preset(preset);
  if (!align.empty()) options.alignment = alignment_from_name(align);
  options.poses_to_align = poses_to_align.value_or(options.poses_to_align);
  options.estimate_scale = estimate_scale.value_or(options.estimate_scale);
  if (!plane.empty()) options.plane = choose("plane", plane, planes);
  resolve_matching(*this, options);
  resolve_relative(*this, options.relative);
  options.check();
  return options;
}

}  // namespace framewise::apps
