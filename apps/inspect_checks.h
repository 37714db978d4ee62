// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "framewise/evaluation/frame_rate.h"
#include "inspect_sampling.h"

namespace framewise::apps {

enum class Verdict { kFine, kWarning, kUntold, kNothingToCheck };

// What was looked for, and what was found: a sentence.
struct Check {
  std::string name;
  Verdict verdict = Verdict::kUntold;
  std::string text;
};

// Everything that is known of a recording before it is judged.
struct Inspection {
  Dataset dataset;
  FrameRate frames, truth_poses;
  double truth_coverage = 0;  // share of the frames whose truth is known
  std::vector<std::size_t> truth_jumps;
  std::size_t out_of_step = 0;  // frames whose depth is more than 10 ms off
  double median_delay = 0;      // of depth, as an absolute value (s)
  ImageEvidence images;
};

Inspection inspect_recording(Dataset dataset, double max_truth_gap, std::uint64_t seed);

// The mistakes that users make most, one after the other.
std::vector<Check> check_recording(const Inspection& inspection);

}  // namespace framewise::apps
