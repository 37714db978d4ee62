// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/evaluation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr double deg_from_rad = 180 / M_PI;

void check_trajectory(const Trajectory& trajectory, const std::string& name) {
  const auto refuse = [&](std::size_t i, const std::string& what) {
    throw std::invalid_argument(name + ": pose " + std::to_string(i) + " " + what);
  };
  if (trajectory.times.size() != trajectory.world_from_cam.size())
    throw std::invalid_argument(name + " has " + std::to_string(trajectory.times.size()) + " times and " +
                                std::to_string(trajectory.world_from_cam.size()) +
                                " poses, expected as many");
  if (trajectory.empty()) throw std::invalid_argument(name + " has no poses, expected one or more");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Pose& pose = trajectory.world_from_cam[i];
    if (!std::isfinite(trajectory.times[i]) || !pose.R.allFinite() || !pose.t.allFinite())
      refuse(i, "holds a number that is not finite");
    if (i > 0 && trajectory.times[i] <= trajectory.times[i - 1])
      refuse(i, "is not later than the one before, expected times that increase");
    // Matrices of files are rotations to their printed digits, the same limit as their reader has.
    if (!((pose.R * pose.R.transpose()).isIdentity(1e-3) && pose.R.determinant() > 0))
      refuse(i, "has no rotation: R R' is not the identity or det R is not 1");
  }
}

Trajectory cut(const Trajectory& trajectory, double from, double to) {
  Trajectory kept;
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    if (trajectory.times[i] >= from && trajectory.times[i] <= to)
      kept.add(trajectory.times[i], trajectory.world_from_cam[i]);
  return kept;
}

std::vector<double> in_degrees(std::vector<double> errors) {
  for (double& e : errors) e *= deg_from_rad;
  return errors;
}

std::optional<RelativeErrors> relative_errors_of(const std::vector<RelativeMotion>& motions,
                                                 RelativeErrorOrder order) {
  if (motions.empty()) return std::nullopt;
  return RelativeErrors{statistics(relative_errors(motions, PoseRelation::kTranslation, order)),
                        statistics(in_degrees(relative_errors(motions, PoseRelation::kRotationAngle, order))),
                        statistics(relative_errors(motions, PoseRelation::kDirection, order))};
}

// The position at which a camera that stands still ends up. Every alignment that may move it freely puts it
// into the middle of the poses it was fitted to; the others leave it where the first pose was.
Eigen::Vector3d resting_place(const TrajectoryPair& unaligned, const EvaluationOptions& options) {
  const auto& reference = unaligned.reference.world_from_cam;
  switch (options.alignment) {
    case Alignment::kNone:
    case Alignment::kScale:
      return unaligned.estimate.world_from_cam[0].t;
    case Alignment::kOrigin:
      return reference[0].t;
    default: {
      const std::size_t n =
          options.poses_to_align == 0 ? reference.size() : std::min(options.poses_to_align, reference.size());
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < n; ++i) sum += reference[i].t;
      return sum / static_cast<double>(n);
    }
  }
}

StaticBaseline static_baseline(const TrajectoryPair& unaligned, std::vector<RelativeMotion> motions,
                               const EvaluationOptions& options) {
  TrajectoryPair still = unaligned;
  const Eigen::Vector3d place = resting_place(unaligned, options);
  for (Pose& pose : still.estimate.world_from_cam) pose.t = place;
  if (options.plane) {
    still.reference = projected(still.reference, *options.plane);
    still.estimate = projected(still.estimate, *options.plane);
  }
  StaticBaseline baseline;
  baseline.ate = statistics(absolute_errors(still, PoseRelation::kTranslation)).rmse;
  for (RelativeMotion& motion : motions) {
    motion.estimate = Pose{};
    motion.estimate_distance = 0;
  }
  if (const auto rpe = relative_errors_of(motions, options.relative.resolved_order())) {
    baseline.rpe_translation = rpe->translation.rmse;
    baseline.rpe_rotation_deg = rpe->rotation_deg.rmse;
  }
  return baseline;
}

std::vector<RelativeMotion> motions_of(const TrajectoryPair& poses, Trajectory reference, Trajectory estimate,
                                       const EvaluationOptions& options) {
  const RelativeErrorOptions& relative = options.relative;
  if (relative.resolved_pairs() != PairChoice::kTum) return relative_motions(poses, relative);
  if (options.plane) {
    reference = projected(reference, *options.plane);
    estimate = projected(estimate, *options.plane);
  }
  return relative_motions_tum(reference, estimate, options.association.time_offset, relative.delta,
                              relative.unit);
}

double time_span(const Trajectory& trajectory) { return trajectory.times.back() - trajectory.times.front(); }

constexpr std::array alignments = {Alignment::kNone,  Alignment::kSe3, Alignment::kSim3,
                                   Alignment::kScale, Alignment::kYaw, Alignment::kOrigin};
constexpr std::array delta_units = {DeltaUnit::kFrames, DeltaUnit::kSeconds, DeltaUnit::kMetres,
                                    DeltaUnit::kDegrees, DeltaUnit::kRadians};

template <class Names>
auto from_name(const Names& values, const std::string& name, const std::string& what) {
  std::string expected;
  for (const auto value : values) {
    if (name_of(value) == name) return value;
    expected.append(" ").append(name_of(value));
  }
  throw std::invalid_argument(what + " is '" + name + "', expected one of" + expected);
}

}  // namespace

void EvaluationOptions::check() const {
  const auto refuse = [](const std::string& name, double found, const std::string& expected) {
    throw std::invalid_argument(name + " is " + std::to_string(found) + ", expected " + expected);
  };
  if (!(association.max_difference >= 0) || !std::isfinite(association.max_difference))
    refuse("association.max_difference", association.max_difference, "seconds from 0");
  if (!std::isfinite(association.time_offset))
    refuse("association.time_offset", association.time_offset, "seconds");
  if (!(estimate_scale > 0) || !std::isfinite(estimate_scale))
    refuse("estimate_scale", estimate_scale, "a number above 0");
  if (!(from_time <= to_time)) refuse("from_time", from_time, "a time not after to_time");
  relative.check();
}

Evaluation evaluate(const Trajectory& reference, const Trajectory& estimate,
                    const EvaluationOptions& options) {
  options.check();
  check_trajectory(reference, "reference");
  check_trajectory(estimate, "estimate");

  Evaluation e;
  e.options = options;
  e.options.relative.pairs = options.relative.resolved_pairs();
  e.options.relative.order = options.relative.resolved_order();

  const Trajectory truth = cut(reference, options.from_time, options.to_time);
  if (truth.empty()) throw std::invalid_argument("reference has no poses between from_time and to_time");
  const Trajectory scaled = transformed({options.estimate_scale, {}}, estimate);
  const TrajectoryPair matched = associate(truth, scaled, options.association);
  if (matched.size() < 2)
    throw std::invalid_argument(
        "only 1 pose of the estimate matches the reference in time, expected 2 or more");

  e.reference_from_estimate = align(matched, options.alignment, options.poses_to_align);
  e.poses = {matched.reference, transformed(e.reference_from_estimate, matched.estimate)};
  if (options.plane)
    e.poses = {projected(e.poses.reference, *options.plane), projected(e.poses.estimate, *options.plane)};
  e.motions = motions_of(e.poses, truth, transformed(e.reference_from_estimate, scaled), e.options);

  e.ate = statistics(absolute_errors(e.poses, PoseRelation::kTranslation));
  e.ate_rotation_deg = statistics(in_degrees(absolute_errors(e.poses, PoseRelation::kRotationAngle)));
  e.rpe = relative_errors_of(e.motions, e.options.relative.resolved_order());
  e.axes = axis_errors(e.poses);
  if (SegmentErrors kitti = kitti_segment_errors(e.poses); !kitti.segments.empty())
    e.kitti = std::move(kitti);
  e.static_baseline = static_baseline(matched, e.motions, e.options);

  e.path_length = path_length(e.poses.reference);
  e.reference_poses = truth.size();
  const double offset = options.association.time_offset;
  e.estimate_poses = cut(estimate, options.from_time - offset, options.to_time - offset).size();
  e.estimate_poses = std::max(e.estimate_poses, matched.size());  // a match may lie just outside the span
  e.matched = matched.size();
  e.coverage = static_cast<double>(e.matched) / static_cast<double>(e.estimate_poses);
  e.time_coverage = time_span(truth) > 0 ? time_span(e.poses.reference) / time_span(truth) : 1;
  return e;
}

std::string name_of(Alignment alignment) {
  switch (alignment) {
    case Alignment::kNone:
      return "none";
    case Alignment::kSe3:
      return "se3";
    case Alignment::kSim3:
      return "sim3";
    case Alignment::kScale:
      return "scale";
    case Alignment::kYaw:
      return "yaw";
    default:
      return "origin";
  }
}

Alignment alignment_from_name(const std::string& name) { return from_name(alignments, name, "alignment"); }
DeltaUnit delta_unit_from_name(const std::string& name) { return from_name(delta_units, name, "unit"); }

}  // namespace framewise
