// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "framewise/evaluation/axis_errors.h"
#include "framewise/evaluation/kitti_segments.h"
#include "framewise/evaluation/motion_pairs.h"
#include "framewise/evaluation/statistics.h"
#include "framewise/evaluation/trajectory_alignment.h"

namespace framewise {

struct EvaluationOptions {
  AssociationOptions association;

  // Odometry starts wherever it likes, so its world is laid onto the truth's; its scale is not forgiven.
  Alignment alignment = Alignment::kSe3;
  std::size_t poses_to_align = 0;  // the first so many matched poses; 0: all
  double estimate_scale = 1;  // the estimate's positions are multiplied by this first (TUM tools' --scale)

  RelativeErrorOptions relative;
  std::optional<Plane> plane;  // after alignment, both are projected onto it

  // Only reference poses of this time span count (s).
  double from_time = -std::numeric_limits<double>::infinity();
  double to_time = std::numeric_limits<double>::infinity();

  void check() const;  // throws std::invalid_argument naming the value
};

// What a camera that never moved would have scored (RMSE): same matches, same alignment, same pairs.
struct StaticBaseline {
  double ate = 0;                          // m
  std::optional<double> rpe_translation;   // m
  std::optional<double> rpe_rotation_deg;  // unset where there are no pairs
};

struct RelativeErrors {
  Statistics translation;   // m
  Statistics rotation_deg;  // degrees, as people read them
  Statistics direction;     // of the translations' unit vectors, 0 to 2 (PoseRelation::kDirection)
};

struct Evaluation {
  EvaluationOptions options;  // as used: pairs and order resolved

  Statistics ate;                     // distance of the positions (m)
  Statistics ate_rotation_deg;        // angle between the orientations (degrees)
  std::optional<RelativeErrors> rpe;  // unset when no two poses are delta apart
  AxisErrors axes;
  std::optional<SegmentErrors> kitti;  // unset where the path is shorter than 100 m
  StaticBaseline static_baseline;

  Similarity reference_from_estimate;  // the alignment found, of the estimate after estimate_scale
  double path_length = 0;              // of the reference along the matched poses (m)

  std::size_t reference_poses = 0;
  std::size_t estimate_poses = 0;  // within from_time and to_time
  std::size_t matched = 0;
  double coverage = 0;       // matched / estimate_poses: the share of the estimate that was judged
  double time_coverage = 0;  // share of the reference's time span between the first and last matched pose

  // What the figures were made of: both trajectories matched, aligned and projected, and the pairs' motions.
  TrajectoryPair poses;
  std::vector<RelativeMotion> motions;
};

// Errors of an estimated trajectory against the true one.
//   ATE: Sturm, Engelhard, Endres, Burgard, Cremers, A Benchmark for the Evaluation of RGB-D SLAM Systems,
//   IROS 2012, Eq. (3); RPE: the same paper, Eq. (1)-(2), over the pairs that the options choose.
// Throws std::invalid_argument when fewer than two poses match in time, for an empty trajectory, times that
// do not increase, a number that is not finite, a matrix that is not a rotation, and for wrong options.
Evaluation evaluate(const Trajectory& reference, const Trajectory& estimate,
                    const EvaluationOptions& options);

// Plain names, as the command line has them; the other way throws std::invalid_argument listing the names.
std::string name_of(Alignment alignment);
Alignment alignment_from_name(const std::string& name);
DeltaUnit delta_unit_from_name(const std::string& name);

}  // namespace framewise
