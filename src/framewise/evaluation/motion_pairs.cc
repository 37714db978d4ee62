// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/motion_pairs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "framewise/evaluation/statistics.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using IndexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

constexpr double rad_from_deg = M_PI / 180;

double angle_between(const Trajectory& trajectory, std::size_t i, std::size_t j) {
  return rotation_angle(trajectory.world_from_cam[i].R.transpose() * trajectory.world_from_cam[j].R);
}

double distance_between(const Trajectory& trajectory, std::size_t i, std::size_t j) {
  return (trajectory.world_from_cam[j].t - trajectory.world_from_cam[i].t).norm();
}

// How far along the trajectory each pose is, in the unit (degrees as radians).
std::vector<double> progress(const Trajectory& trajectory, DeltaUnit unit) {
  if (unit == DeltaUnit::kSeconds) return trajectory.times;
  std::vector<double> along(trajectory.size(), 0.0);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const double step = unit == DeltaUnit::kFrames   ? 1
                        : unit == DeltaUnit::kMetres ? distance_between(trajectory, i - 1, i)
                                                     : angle_between(trajectory, i - 1, i);
    along[i] = along[i - 1] + step;
  }
  return along;
}

// Pairs (0, d), (d, 2d), ...: a mark is set at the first pose that is delta past the last one.
IndexPairs consecutive_pairs(const std::vector<double>& along, const RelativeErrorOptions& options,
                             double delta) {
  // Stamps at a steady rate meet delta but for their last digits.
  const double slack = options.unit == DeltaUnit::kSeconds ? 1e-6 : 0;
  bool marked = options.unit != DeltaUnit::kMetres || options.from_first_pose;
  IndexPairs pairs;
  std::size_t mark = 0;
  double since = 0;
  for (std::size_t i = 1; i < along.size(); ++i) {
    since += along[i] - along[i - 1];
    if (since < delta * (1 - slack)) continue;
    if (marked) pairs.emplace_back(mark, i);
    marked = true;
    mark = i;
    since = 0;
  }
  return pairs;
}

// From every pose to the one nearest to delta further on; of two equally near the first.
IndexPairs nearest_pairs(const std::vector<double>& along, double delta, double max_difference) {
  IndexPairs pairs;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const std::span<const double> rest(along.begin() + i + 1, along.end());
    const double nearest = rest[nearest_index(rest, along[i] + delta)];
    if (std::abs(nearest - along[i] - delta) > max_difference) continue;
    const auto j = std::lower_bound(rest.begin(), rest.end(), nearest) - rest.begin();
    pairs.emplace_back(i, i + 1 + j);
  }
  return pairs;
}

// Every pair whose own rotation is delta.
IndexPairs rotation_pairs(const Trajectory& trajectory, double delta, double max_difference) {
  IndexPairs pairs;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    for (std::size_t j = i + 1; j < trajectory.size(); ++j) {
      const double angle = angle_between(trajectory, i, j);
      if (delta - max_difference <= angle && angle <= delta + max_difference) pairs.emplace_back(i, j);
    }
  return pairs;
}

IndexPairs pairs_of(const Trajectory& trajectory, const RelativeErrorOptions& options) {
  const double delta = options.unit == DeltaUnit::kDegrees ? options.delta * rad_from_deg : options.delta;
  const double max_difference = options.tolerance * delta;
  const bool angle = options.unit == DeltaUnit::kDegrees || options.unit == DeltaUnit::kRadians;
  if (options.resolved_pairs() == PairChoice::kConsecutive)
    return consecutive_pairs(progress(trajectory, options.unit), options, delta);
  if (angle) return rotation_pairs(trajectory, delta, max_difference);
  return nearest_pairs(progress(trajectory, options.unit), delta,
                       options.unit == DeltaUnit::kFrames ? 0.5 : max_difference);
}

RelativeMotion motion_of(const Trajectory& reference, std::size_t k, std::size_t l,
                         const Trajectory& estimate, std::size_t i, std::size_t j) {
  const auto &A = reference.world_from_cam, &B = estimate.world_from_cam;
  return {estimate.times[i],
          estimate.times[j],
          A[k].inverse() * A[l],
          B[i].inverse() * B[j],
          distance_between(reference, k, l),
          distance_between(estimate, i, j),
          A[l],
          B[j]};
}

double median_interval(const Trajectory& trajectory) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    intervals.push_back(trajectory.times[i] - trajectory.times[i - 1]);
  return intervals.empty() ? 0 : median(intervals);
}

}  // namespace

PairChoice RelativeErrorOptions::resolved_pairs() const {
  return pairs.value_or(unit == DeltaUnit::kSeconds ? PairChoice::kTum : PairChoice::kConsecutive);
}

RelativeErrorOrder RelativeErrorOptions::resolved_order() const {
  return order.value_or(resolved_pairs() == PairChoice::kTum ? RelativeErrorOrder::kTum
                                                             : RelativeErrorOrder::kEvo);
}

void RelativeErrorOptions::check() const {
  const auto refuse = [](const std::string& name, double found, const std::string& expected) {
    throw std::invalid_argument(name + " is " + std::to_string(found) + ", expected " + expected);
  };
  if (!(delta > 0) || !std::isfinite(delta)) refuse("delta", delta, "a number above 0");
  if (unit == DeltaUnit::kFrames && delta != std::floor(delta)) refuse("delta", delta, "whole frames");
  if (unit == DeltaUnit::kDegrees && delta > 180) refuse("delta", delta, "at most 180 degrees");
  if (unit == DeltaUnit::kRadians && delta > M_PI) refuse("delta", delta, "at most pi radians");
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) refuse("tolerance", tolerance, "a number from 0");
}

std::vector<RelativeMotion> relative_motions(const TrajectoryPair& matched,
                                             const RelativeErrorOptions& options) {
  const Trajectory &reference = matched.reference, &estimate = matched.estimate;
  std::vector<RelativeMotion> motions;
  for (const auto& [i, j] : pairs_of(options.pairs_from_reference ? reference : estimate, options))
    motions.push_back(motion_of(reference, i, j, estimate, i, j));
  return motions;
}

std::vector<RelativeMotion> relative_motions_tum(const Trajectory& reference, const Trajectory& estimate,
                                                 double time_offset, double delta, DeltaUnit unit) {
  if (unit == DeltaUnit::kDegrees) delta *= rad_from_deg;
  const std::vector<double> along = progress(estimate, unit);
  const double max_difference = 2 * median_interval(reference);
  std::vector<RelativeMotion> motions;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const std::size_t j = nearest_index(along, along[i] + delta);
    if (j + 1 == estimate.size()) continue;
    const double from = estimate.times[i] + time_offset, to = estimate.times[j] + time_offset;
    const std::size_t k = nearest_index(reference.times, from), l = nearest_index(reference.times, to);
    if (std::abs(reference.times[k] - from) > max_difference) continue;
    if (std::abs(reference.times[l] - to) > max_difference) continue;
    motions.push_back(motion_of(reference, k, l, estimate, i, j));
  }
  return motions;
}

std::string name_of(DeltaUnit unit) {
  switch (unit) {
    case DeltaUnit::kFrames:
      return "frames";
    case DeltaUnit::kSeconds:
      return "seconds";
    case DeltaUnit::kMetres:
      return "metres";
    case DeltaUnit::kDegrees:
      return "degrees";
    default:
      return "radians";
  }
}

}  // namespace framewise
