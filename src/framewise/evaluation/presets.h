// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "framewise/evaluation/evaluation.h"

namespace framewise {

// The settings under which other tools print their figures, so that ours can be laid beside theirs:
//   evo    evo_ape and evo_rpe with nothing but the files: nearest stamp within 0.01 s, no alignment, delta 1
//          frame, consecutive pairs, E = B^-1 A.
//   tum    evaluate_ate and evaluate_rpe --fixed_delta of the TUM RGB-D benchmark: greedy matches within 0.02
//          s, rotation and translation aligned, delta 1 s from every pose, E = A B^-1.
//   kitti  the odometry devkit: pose i with pose i, no alignment, E = B^-1 A; its segment errors stand in
//          Evaluation::kitti.
//   lab    frame by frame against a motion-capture truth: truth interpolated to the stamp, first pose laid
//          onto the truth's, delta 1 frame, E = B^-1 A; steps of unknown length by the directions of the
//          translations (RelativeErrors::direction).
// Throws std::invalid_argument listing the names.
EvaluationOptions evaluation_preset(const std::string& name);

}  // namespace framewise
