// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/pose_convention.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "framewise/evaluation/statistics.h"
#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kLeastRotation = 2 * kDegree, kLeastParallax = 1.5 * kDegree;
constexpr std::size_t kFewestMotions = 4;
// How much may be wrong: of the rotation, and of the direction.
struct Tolerance {
  double share, direction;
};
constexpr Tolerance kAsReadTolerance = {1.0 / 2, 45 * kDegree}, kTolerance = {1.0 / 3, 30 * kDegree};
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
// A frame that is turned by less is a calibration error, no other convention.
constexpr double kLeastBodyRotation = 10 * kDegree;

bool tells_rotation(const ObservedMotion& motion) {
  return rotation_angle(motion.cam2_from_cam1.R) >= kLeastRotation;
}
bool tells_direction(const ObservedMotion& motion) {
  return motion.parallax >= kLeastParallax && motion.cam2_from_cam1.t.norm() > 0;
}

// The pose that was written w x y z and read x y z w, and the other way round.
Pose scalar_first(const Pose& read) {
  const Eigen::Quaterniond q = read.quaternion();
  return Pose::from_quaternion({q.x(), q.y(), q.z(), q.w()}, read.t);
}
Pose scalar_last(const Pose& read) {
  const Eigen::Quaterniond q = read.quaternion();
  return Pose::from_quaternion({q.z(), q.w(), q.x(), q.y()}, read.t);
}

using Relative = std::function<Pose(const ObservedMotion&)>;  // cam2_from_cam1 of a convention

Pose as_read(const ObservedMotion& m) { return m.world_from_cam2.inverse() * m.world_from_cam1; }
Pose with_scalar_first(const ObservedMotion& m) {
  return scalar_first(m.world_from_cam2).inverse() * scalar_first(m.world_from_cam1);
}
Pose with_scalar_last(const ObservedMotion& m) {
  return scalar_last(m.world_from_cam2).inverse() * scalar_last(m.world_from_cam1);
}
Pose inverted(const ObservedMotion& m) { return m.world_from_cam2 * m.world_from_cam1.inverse(); }

struct Errors {
  double rotation = kNoNumber, direction = kNoNumber;
};

double median_or_none(const std::vector<double>& values) {
  return values.empty() ? kNoNumber : median(values);
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Errors errors_of(std::span<const ObservedMotion> motions, const Relative& relative) {
  std::vector<double> rotations, directions;
  for (const ObservedMotion& motion : motions) {
    const Pose pose = relative(motion);
    if (tells_rotation(motion))
      rotations.push_back(rotation_angle(pose.R * motion.cam2_from_cam1.R.transpose()));
    if (tells_direction(motion)) directions.push_back(angle_between(pose.t, motion.cam2_from_cam1.t));
  }
  return {median_or_none(rotations), median_or_none(directions)};
}

// Where nothing tells, nothing contradicts.
bool fits(const Errors& errors, double median_rotation, const Tolerance& most) {
  return !(errors.rotation > most.share * median_rotation) && !(errors.direction > most.direction);
}

using VectorPair = std::pair<Eigen::Vector3d, Eigen::Vector3d>;  // in the body's axes, in the camera's

// Rotation vectors; directions where the camera hardly turned, which a lever arm then moves little.
std::vector<VectorPair> vectors_of_motion(std::span<const ObservedMotion> motions) {
  std::vector<VectorPair> rotations, directions;
  for (const ObservedMotion& motion : motions) {
    const Pose read = as_read(motion);
    if (tells_rotation(motion)) rotations.emplace_back(so3_log(read.R), so3_log(motion.cam2_from_cam1.R));
    if (tells_direction(motion) && read.t.norm() > 0)
      directions.emplace_back(read.t.normalized(), motion.cam2_from_cam1.t.normalized());
  }
  return rotations.size() >= kFewestMotions ? rotations : directions;
}

// The rotation from the one to the other, of all motions, then of the better ones.
Eigen::Matrix3d fit_cam_from_body(std::span<const ObservedMotion> motions) {
  const std::vector<VectorPair> vectors = vectors_of_motion(motions);
  Eigen::Matrix3d C = Eigen::Matrix3d::Identity();
  double largest = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 3; ++round) {
    Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
    std::vector<double> residuals;
    for (const auto& [body, cam] : vectors)
      if ((C * body - cam).norm() <= largest) M += cam * body.transpose();
    C = nearest_rotation(M);
    for (const auto& [body, cam] : vectors) residuals.push_back((C * body - cam).norm());
    if (!residuals.empty()) largest = 2 * median(residuals);
  }
  return C;
}

double median_rotation_of(std::span<const ObservedMotion> motions) {
  std::vector<double> angles;
  for (const ObservedMotion& motion : motions)
    if (tells_rotation(motion)) angles.push_back(rotation_angle(motion.cam2_from_cam1.R));
  return median_or_none(angles);
}

}  // namespace

ConventionJudgement judge_convention(std::span<const ObservedMotion> motions) {
  ConventionJudgement judgement;
  for (const ObservedMotion& motion : motions)
    judgement.motions += tells_rotation(motion) || tells_direction(motion);
  judgement.median_rotation = median_rotation_of(motions);
  const Errors read = errors_of(motions, as_read);
  judgement.rotation_error = read.rotation;
  judgement.direction_error = read.direction;
  if (static_cast<std::size_t>(judgement.motions) < kFewestMotions) return judgement;

  judgement.convention = PoseConvention::kAsRead;
  if (fits(read, judgement.median_rotation, kAsReadTolerance)) return judgement;
  const std::array<std::pair<PoseConvention, Relative>, 3> candidates = {
      {{PoseConvention::kScalarFirst, with_scalar_first},
       {PoseConvention::kScalarLast, with_scalar_last},
       {PoseConvention::kInverse, inverted}}};
  for (const auto& [convention, relative] : candidates) {
    judgement.convention = convention;
    if (fits(errors_of(motions, relative), judgement.median_rotation, kTolerance)) return judgement;
  }

  // A lever arm between body and camera moves directions: they are asked only where rotations do not tell.
  const Eigen::Matrix3d C = fit_cam_from_body(motions);
  const Errors turned = errors_of(motions, [&](const ObservedMotion& motion) {
    return Pose{C * as_read(motion).R * C.transpose(), C * as_read(motion).t};
  });
  const bool agrees = std::isnan(turned.rotation)
                          ? turned.direction <= kTolerance.direction
                          : turned.rotation <= kTolerance.share * judgement.median_rotation;
  const bool is_body = agrees && rotation_angle(C) >= kLeastBodyRotation;
  judgement.convention = is_body ? PoseConvention::kBodyFrame : PoseConvention::kNone;
  if (is_body) judgement.cam_from_body = C;
  return judgement;
}

}  // namespace framewise
