// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/pose_error.h"

#include <cmath>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

double size_of(const Pose& E, PoseRelation relation) {
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  switch (relation) {
    case PoseRelation::kRotationAngle:
      return rotation_angle(E.R);
    case PoseRelation::kRotationPart:
      return (E.R - I).norm();
    case PoseRelation::kFull:
      return std::hypot((E.R - I).norm(), E.t.norm());
    default:
      return E.t.norm();
  }
}

Eigen::Vector3d direction(const Eigen::Vector3d& t) {
  constexpr double kStandsStill = 1e-6;  // m: shorter steps have no direction and are taken as they are
  return t.norm() > kStandsStill ? Eigen::Vector3d(t.normalized()) : t;
}

}  // namespace

std::vector<double> absolute_errors(const TrajectoryPair& matched, PoseRelation relation) {
  if (relation == PoseRelation::kPointDistanceRatio || relation == PoseRelation::kDirection)
    throw std::invalid_argument(
        "absolute_errors: point_distance_ratio and direction are defined for relative errors only");
  std::vector<double> errors;
  for (std::size_t i = 0; i < matched.size(); ++i) {
    const Pose& reference = matched.reference.world_from_cam[i];
    const Pose& estimate = matched.estimate.world_from_cam[i];
    const bool positions = relation == PoseRelation::kTranslation || relation == PoseRelation::kPointDistance;
    errors.push_back(positions ? (estimate.t - reference.t).norm()
                               : size_of(estimate.inverse() * reference, relation));
  }
  return errors;
}

std::vector<double> relative_errors(std::span<const RelativeMotion> motions, PoseRelation relation,
                                    RelativeErrorOrder order) {
  std::vector<double> errors;
  for (const RelativeMotion& motion : motions) {
    const Pose &A = motion.reference, &B = motion.estimate;
    const double difference = std::abs(motion.reference_distance - motion.estimate_distance);
    if (relation == PoseRelation::kDirection) {
      errors.push_back((direction(A.t) - direction(B.t)).norm());
    } else if (relation == PoseRelation::kPointDistance) {
      errors.push_back(difference);
    } else if (relation == PoseRelation::kPointDistanceRatio) {
      if (motion.reference_distance > 0) errors.push_back(difference / motion.reference_distance);
    } else {
      errors.push_back(
          size_of(order == RelativeErrorOrder::kTum ? A * B.inverse() : B.inverse() * A, relation));
    }
  }
  return errors;
}

Trajectory projected(const Trajectory& trajectory, Plane plane) {
  const int normal = plane == Plane::kXy ? 2 : plane == Plane::kXz ? 1 : 0;
  Trajectory flat = trajectory;
  for (Pose& pose : flat.world_from_cam) {
    pose.R = so3_exp(euler_zyx(pose.R)[normal] * Eigen::Vector3d::Unit(normal));
    pose.t[normal] = 0;
  }
  return flat;
}

}  // namespace framewise
