// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "framewise/evaluation/evaluation.h"

namespace framewise::apps {

// EvaluationOptions as typed. Unset: as the preset has it.
struct EvaluateOptions {
  std::string preset, align, unit, association, pairs, plane;
  std::optional<double> delta, tolerance, max_difference, time_offset, estimate_scale, from_time, to_time;
  std::optional<std::size_t> poses_to_align;
  bool from_first_pose = false, pairs_from_reference = false;

  void add_to(CLI::App& app);

  // The preset, and over it what was asked for by name. Throws std::invalid_argument naming the option, what
  // was found and what was expected.
  EvaluationOptions resolved() const;
};

}  // namespace framewise::apps
