// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/trajectory_alignment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

std::vector<Eigen::Vector3d> positions(const Trajectory& trajectory, std::size_t count) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(trajectory.world_from_cam[i].t);
  return points;
}

Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

struct Moments {
  Eigen::Vector3d mean_reference, mean_estimate;
  Eigen::Matrix3d covariance;  // of the reference with the estimate
  double variance_estimate;
  Eigen::Matrix3d turn;  // sum of R_reference R_estimate', the orientations' vote on the rotation
};

Moments moments_of(const TrajectoryPair& matched, std::size_t count) {
  const auto reference = positions(matched.reference, count), estimate = positions(matched.estimate, count);
  Moments s{mean(reference), mean(estimate), Eigen::Matrix3d::Zero(), 0, Eigen::Matrix3d::Zero()};
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d d = estimate[i] - s.mean_estimate;
    s.covariance += (reference[i] - s.mean_reference) * d.transpose() / static_cast<double>(count);
    s.variance_estimate += d.squaredNorm() / static_cast<double>(count);
    s.turn += matched.reference.world_from_cam[i].R * matched.estimate.world_from_cam[i].R.transpose();
  }
  return s;
}

// The positions' rotation; where they leave it free, the orientations decide among the best. Their weight is
// small enough not to move what the positions say, and large enough to be seen by a double.
Eigen::Matrix3d rotation_of_positions(const TrajectoryPair& matched, std::size_t count, const Moments& s) {
  if (const auto fit = kabsch(positions(matched.estimate, count), positions(matched.reference, count)))
    return fit->R;
  const double size = s.covariance.norm();
  return nearest_rotation(s.covariance + (size > 0 ? 1e-9 * size : 1.0) * s.turn / s.turn.norm());
}

// Rotation about z that maximises trace(R' covariance).
Eigen::Matrix3d yaw_of_positions(const Moments& s) {
  const auto angle_of = [](const Eigen::Matrix3d& M) {
    return std::atan2(M(1, 0) - M(0, 1), M(0, 0) + M(1, 1));
  };
  const bool free = s.covariance.topLeftCorner<2, 2>().norm() == 0;
  return so3_exp({0, 0, angle_of(free ? s.turn : s.covariance)});
}

double scale_of_positions(const Moments& s, const Eigen::Matrix3d& R) {
  if (!(std::sqrt(s.variance_estimate) > 1e-12 * (1 + s.mean_estimate.norm())))
    throw std::invalid_argument(
        "alignment: the estimate never moves, so its scale cannot be found; use se3 or none");
  return (R.transpose() * s.covariance).trace() / s.variance_estimate;  // Umeyama Eq. (42)
}

}  // namespace

Similarity align(const TrajectoryPair& matched, Alignment alignment, std::size_t count) {
  if (matched.size() == 0) throw std::invalid_argument("alignment: no matched poses, expected one or more");
  if (alignment == Alignment::kNone) return {};
  if (alignment == Alignment::kOrigin)
    return {1, matched.reference.world_from_cam[0] * matched.estimate.world_from_cam[0].inverse()};

  count = count == 0 ? matched.size() : std::min(count, matched.size());
  const Moments s = moments_of(matched, count);
  const Eigen::Matrix3d R =
      alignment == Alignment::kYaw ? yaw_of_positions(s) : rotation_of_positions(matched, count, s);
  const bool scaled = alignment == Alignment::kSim3 || alignment == Alignment::kScale;
  const double scale = scaled ? scale_of_positions(s, R) : 1;
  if (alignment == Alignment::kScale) return {scale, {}};
  return {scale, {R, s.mean_reference - scale * R * s.mean_estimate}};
}

Trajectory transformed(const Similarity& b_from_a, const Trajectory& in_a) {
  Trajectory in_b = in_a;
  for (Pose& pose : in_b.world_from_cam) {
    pose.t *= b_from_a.scale;
    pose = b_from_a.pose * pose;
  }
  return in_b;
}

}  // namespace framewise
