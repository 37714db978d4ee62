// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "framewise/geometry/trajectory.h"

namespace framewise {

// Which pose of the reference judges which pose of the estimate.
//   nearest: every pose of the shorter trajectory takes the nearest stamp of the longer one, if it is at most
//     max_difference away; of two equally near the earlier; one long stamp may serve twice. evo's rule.
//   greedy: all pairs closer than max_difference (strictly), the closest first, each pose once. The rule of
//     the TUM RGB-D benchmark's tools.
//   interpolated: the reference is moved to every stamp of the estimate, linear and slerp, between two poses
//     that are at most 2 max_difference apart: no stamp error is left.
//   index: pose i with pose i; the lengths must be equal. For files without stamps (KITTI).
enum class AssociationMethod { kNearest, kGreedy, kInterpolated, kIndex };

struct AssociationOptions {
  AssociationMethod method = AssociationMethod::kNearest;
  double max_difference = 0.01;  // s; evo's default. The TUM tools use 0.02.
  double time_offset = 0;        // s, added to the estimate's stamps
};

struct Match {
  std::size_t reference;
  std::size_t estimate;
  bool operator==(const Match&) const = default;
};

// Matches in the order of time; both lists of stamps (s) increasing.
std::vector<Match> associate_nearest(std::span<const double> reference, std::span<const double> estimate,
                                     double max_difference, double time_offset = 0);
std::vector<Match> associate_greedy(std::span<const double> reference, std::span<const double> estimate,
                                    double max_difference, double time_offset = 0);

// Position of the value nearest to x in an increasing, non-empty list; of two equally near the earlier.
std::size_t nearest_index(std::span<const double> increasing, double x);

// Two trajectories of equal length: pose i of one is judged by pose i of the other. Each keeps its stamps.
struct TrajectoryPair {
  Trajectory reference;
  Trajectory estimate;
  std::size_t size() const { return estimate.size(); }
};

// The matched poses alone. Throws std::invalid_argument when nothing matches, saying how many poses each has,
// their time spans and the limit, and when method is index and the lengths differ.
TrajectoryPair associate(const Trajectory& reference, const Trajectory& estimate,
                         const AssociationOptions& options);

}  // namespace framewise
