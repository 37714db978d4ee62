// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framewise/evaluation/pose_error.h"

namespace framewise {

enum class DeltaUnit { kFrames, kSeconds, kMetres, kDegrees, kRadians };

// Which pairs of poses a relative error is taken over. Frames are matched poses, metres are travelled (the
// sum of the steps), degrees and radians are turned.
//   consecutive: pairs that do not overlap, each beginning where the last ended, as soon as delta is reached.
//     evo's default. Of metres the first pair begins where the first delta is reached, not at the first pose,
//     unless from_first_pose.
//   all: from every pose. Metres: to the pose nearest to delta away, if within the tolerance. Seconds: the
//     same. Angles: to every pose whose own rotation is delta within the tolerance. evo's --all_pairs.
//   tum: from every pose of the estimate, matched or not, to its pose nearest to delta away; each meets the
//     reference's nearest stamp; a pair is left out where that is more than twice the reference's median
//     interval away, and where it ends at the estimate's last pose. The TUM tools' --fixed_delta.
enum class PairChoice { kConsecutive, kAll, kTum };

struct RelativeErrorOptions {
  double delta = 1;
  DeltaUnit unit = DeltaUnit::kFrames;
  // Unset: tum for seconds (drift per second was defined by that benchmark, evo has no seconds), else
  // consecutive, evo's default.
  std::optional<PairChoice> pairs;
  // Unset: the order of the tool the pairs come from.
  std::optional<RelativeErrorOrder> order;
  double tolerance = 0.1;             // of delta; what `all` accepts in metres, seconds and angles. evo's
  bool pairs_from_reference = false;  // choose pairs on the reference instead of the estimate (not for tum)

  // Consecutive pairs of metres begin at the first pose: false as evo 1.36 has it, true as evo 1.38.
  bool from_first_pose = false;

  PairChoice resolved_pairs() const;
  RelativeErrorOrder resolved_order() const;
  void check() const;  // throws std::invalid_argument naming the value
};

// The motions of the chosen pairs; may be empty when the trajectory is shorter than delta.
// `matched` serves consecutive and all; `reference` and `estimate`, the whole of both in one world, and the
// offset added to the estimate's stamps (s) serve tum.
std::vector<RelativeMotion> relative_motions(const TrajectoryPair& matched,
                                             const RelativeErrorOptions& options);
std::vector<RelativeMotion> relative_motions_tum(const Trajectory& reference, const Trajectory& estimate,
                                                 double time_offset, double delta, DeltaUnit unit);

// Plain name of a unit, as the command line has it.
std::string name_of(DeltaUnit unit);

}  // namespace framewise
