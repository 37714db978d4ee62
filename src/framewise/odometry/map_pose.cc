// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/odometry/map_pose.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "framewise/geometry/so3.h"
#include "framewise/robust/absolute_pose.h"
#include "framewise/solvers/refine_absolute_pose.h"
#include "framewise/solvers/refine_rgbd_pair.h"

namespace framewise {
namespace {

int count_inliers(const std::vector<MapMatch>& matches, const Pose& pose, double max_error) {
  int count = 0;
  for (const MapMatch& match : matches) count += agrees(match, pose, max_error);
  return count;
}

// Residuals of a match in standard deviations: q of the ray (2 numbers), d of the depth (NaN: none).
struct Whitened {
  double q = std::numeric_limits<double>::infinity(), d = std::numeric_limits<double>::quiet_NaN();
};

Whitened whitened(const MapMatch& match, const Pose& pose, const DepthNoise& noise) {
  Whitened w;
  const Eigen::Vector3d x = pose * match.X;
  if (x.z() <= 0) return w;
  const double iz = 1 / x.z();
  Eigen::Matrix<double, 2, 3> J;
  J << iz, 0, -x.x() * iz * iz, 0, iz, -x.y() * iz * iz;
  const Eigen::Matrix3d S = pose.R * match.S * pose.R.transpose();
  const Eigen::Matrix2d C = J * S * J.transpose() + match.noise.covariance();
  const Eigen::Vector2d r = x.head<2>() * iz - match.ray.head<2>();
  w.q = r.dot(C.inverse() * r);
  if (match.z > 0)
    w.d = (match.z - x.z()) / std::hypot(match.z_share * noise.sigma(match.z), std::sqrt(S(2, 2)));
  return w;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Robust scales of the residuals: of squares of two Gaussian numbers the median is 1.386, of one 0.455.
void measure_scales(const std::vector<MapMatch>& matches, const DepthNoise& noise, MapPose& pose) {
  std::vector<double> q, d2;
  for (const MapMatch& match : matches) {
    const Whitened w = whitened(match, pose.cam_from_reference, noise);
    if (std::isfinite(w.q)) q.push_back(w.q);
    if (std::isfinite(w.d)) d2.push_back(w.d * w.d);
  }
  if (q.size() >= 10) pose.ray_scale *= std::clamp(std::sqrt(median(q) / 1.386), 0.2, 10.0);
  if (d2.size() >= 10) pose.depth_scale *= std::clamp(std::sqrt(median(d2) / 0.455), 0.2, 10.0);
}

MapMatch rescaled(MapMatch match, double ray_scale) {
  match.noise.sigma *= ray_scale;
  return match;
}

void set_symmetric(PointColumns& columns, std::size_t row, std::size_t first, const Eigen::Matrix3d& S) {
  columns.set3(row, first, S(0, 0), S(0, 1), S(0, 2));
  columns.set3(row, first + 3, S(1, 1), S(1, 2), S(2, 2));
}

// Of a point at depth z seen along a ray so uncertain, or so much more so than a ray of sigma `than`.
Eigen::Matrix3d across(double z, const PlaceNoise& noise, double than) {
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  S.topLeftCorner<2, 2>() = z * z * (noise.covariance() - than * than * Eigen::Matrix2d::Identity());
  return S;
}

// The matches as refine_rgbd_pair reads them. What a ray is less certain than the surest one is added to its
// map point, across the line of sight.
Refinement refine(const std::vector<MapMatch>& matches, const Pose& initial, const DepthNoise& noise,
                  double depth_scale, const RobustLoss& loss = {Loss::kCauchy, 2.0}) {
  const auto has_depth = [&](const MapMatch& match) {
    return match.z > 0 && std::abs(whitened(match, initial, noise).d) < 3 * depth_scale;
  };
  std::vector<std::uint8_t> with_depth;
  double surest = std::numeric_limits<double>::infinity();
  for (const MapMatch& match : matches) {
    with_depth.push_back(has_depth(match));
    surest = std::min(surest, match.noise.least());
  }
  const std::size_t both = std::count(with_depth.begin(), with_depth.end(), 1);
  RgbdColumns columns;
  columns.both.reset(both, 19);
  columns.first.reset(matches.size() - both, 13);
  columns.second.reset(0, 13);
  columns.none.reset(0, 7);
  std::size_t next_both = 0, next_first = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const MapMatch& m = matches[i];
    if (with_depth[i]) {
      columns.both.set3(next_both, 1, m.X.x(), m.X.y(), m.X.z());
      set_symmetric(columns.both, next_both, 4, m.S);
      const Eigen::Vector3d X2 = point_at_depth(m.ray, m.z);
      columns.both.set3(next_both, 10, X2.x(), X2.y(), X2.z());
      const Eigen::Matrix3d along =
          point_covariance(m.ray, m.z, 0, depth_scale * m.z_share * noise.sigma(m.z));
      set_symmetric(columns.both, next_both++, 13, along + across(m.z, m.noise, 0));
    } else {
      const double z = std::max(0.01, (initial * m.X).z());
      columns.first.set3(next_first, 1, m.X.x(), m.X.y(), m.X.z());
      set_symmetric(columns.first, next_first, 4,
                    m.S + initial.R.transpose() * across(z, m.noise, surest) * initial.R);
      columns.first.set3(next_first++, 10, m.ray.x(), m.ray.y(), m.ray.z());
    }
  }
  RefineOptions options;
  options.sigma = surest;
  options.loss = loss;
  return refine_rgbd_pair(initial, columns, options);
}

// Of those that agree, at full weight: a robust loss takes weight from what is merely noisy.
Matrix6d covariance_at(const std::vector<MapMatch>& matches, const MapPose& pose, const DepthNoise& noise) {
  std::vector<MapMatch> inliers;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!pose.inliers[i]) continue;
    inliers.push_back(matches[i]);
  }
  if (inliers.size() < 3) return Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  return refine(inliers, pose.cam_from_reference, noise, pose.depth_scale, {Loss::kTrivial, 3}).covariance;
}

}  // namespace

bool agrees(const MapMatch& match, const Pose& cam_from_reference, double max_error) {
  const Eigen::Vector3d x = cam_from_reference * match.X;
  return x.z() > 0 && (x.head<2>() / x.z() - match.ray.head<2>()).norm() < max_error;
}

std::optional<FirstPose> first_pose(const std::vector<MapMatch>& matches, const Pose& prior,
                                    const FirstPoseOptions& options) {
  if (static_cast<int>(matches.size()) < options.min_inliers) return std::nullopt;
  std::vector<Eigen::Vector3d> X, rays;
  for (const MapMatch& match : matches) X.push_back(match.X), rays.push_back(match.ray);
  RefineOptions robust;
  robust.sigma = options.max_error / 4;
  robust.loss = {Loss::kCauchy, 2.0};
  const Pose from_prior = refine_absolute_pose(prior, X, rays, robust).pose;
  FirstPose best{from_prior, count_inliers(matches, from_prior, options.max_error), 0};
  if (2 * best.inliers > static_cast<int>(matches.size()) && best.inliers >= options.min_inliers) return best;

  AbsolutePoseOptions absolute;
  absolute.ransac = options.ransac;
  absolute.max_error = options.max_error;
  absolute.min_inliers = options.min_inliers;
  const auto found = estimate_absolute_pose(X, rays, absolute);
  if (found && static_cast<int>(found->num_inliers) > best.inliers)
    best = {found->cam2_from_cam1, static_cast<int>(found->num_inliers), found->iterations};
  if (best.inliers < options.min_inliers) return std::nullopt;
  return best;
}

ReadoutCorrection readout_correction(const std::vector<MapMatch>& matches, const MapPose& pose) {
  Matrix6d H = Matrix6d::Zero();
  Vector6d h = Vector6d::Zero(), g = Vector6d::Zero();
  double own = 0, pull = 0, different = 0, skewed = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const MapMatch& match = matches[i];
    const Eigen::Vector3d x = pose.cam_from_reference * match.X;
    if (!pose.inliers[i] || x.z() <= 0) continue;
    const double iz = 1 / x.z();
    Eigen::Matrix<double, 2, 3> P;
    P << iz, 0, -x.x() * iz * iz, 0, iz, -x.y() * iz * iz;
    Eigen::Matrix<double, 2, 6> J;
    J << -P * pose.cam_from_reference.R * skew(match.X), P;
    const Eigen::Vector2d r = x.head<2>() * iz - match.ray.head<2>();
    const Eigen::Matrix2d W = match.noise.whitening() / pose.ray_scale;
    const Eigen::Matrix<double, 2, 6> WJ = W * J;
    const Eigen::Vector2d by_readout = W * match.by_readout;
    H += WJ.transpose() * WJ;
    h += WJ.transpose() * by_readout;
    g += WJ.transpose() * (W * r);
    own += by_readout.squaredNorm();
    different += match.by_readout.squaredNorm();
    skewed += match.skew * match.skew;
    pull += by_readout.dot(W * r);
  }
  // Turn rates are known to some tenths, and where both views are skewed alike that is all that differs.
  constexpr double kLeastDifference = 0.4, kFew = 16;
  if (!(different > kLeastDifference * kLeastDifference * skewed)) return {};
  const auto solver = H.ldlt();
  const double information = own - h.dot(solver.solve(h));
  if (!(information > 0)) return {};
  // What the pose and the lens leave is alike in neighbouring residuals: all count as a few.
  return {-(pull - h.dot(solver.solve(g))) / information, kFew * information / std::max(1, pose.num_inliers)};
}

double shift_between(const std::vector<MapMatch>& matches, const Pose& pose1, const Pose& pose2) {
  double squares = 0;
  int count = 0;
  for (const MapMatch& match : matches) {
    const Eigen::Vector3d x1 = pose1 * match.X, x2 = pose2 * match.X;
    if (x1.z() <= 0 || x2.z() <= 0) continue;
    squares += (x1.head<2>() / x1.z() - x2.head<2>() / x2.z()).squaredNorm();
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

MapPose refine_map_pose(const std::vector<MapMatch>& matches, const Pose& initial, const DepthNoise& noise) {
  MapPose pose;
  pose.cam_from_reference = initial;
  // What the residuals show at the initial pose is in part its own error: the noise shrinks as it does.
  std::vector<MapMatch> scaled = matches;
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    pose.ray_scale = pose.depth_scale = 1;
    measure_scales(matches, noise, pose);
    for (std::size_t i = 0; i < matches.size(); ++i) scaled[i] = rescaled(matches[i], pose.ray_scale);
    pose.cam_from_reference = refine(scaled, pose.cam_from_reference, noise, pose.depth_scale).pose;
  }
  pose.ray_scale = pose.depth_scale = 1;
  measure_scales(matches, noise, pose);
  for (std::size_t i = 0; i < matches.size(); ++i) scaled[i] = rescaled(matches[i], pose.ray_scale);
  const Refinement refined = refine(scaled, pose.cam_from_reference, noise, pose.depth_scale);
  pose.cam_from_reference = refined.pose;
  for (const MapMatch& match : scaled) {
    constexpr double kMaxSquare = 11.8;  // three sigma of two numbers
    pose.inliers.push_back(whitened(match, pose.cam_from_reference, noise).q < kMaxSquare);
    pose.num_inliers += pose.inliers.back();
  }
  // Beyond some noise of their own, residuals are of lens, shutter and blur, alike in neighbours, and do not
  // average out.
  constexpr double kOwnNoise = 2;
  const double shared = std::max(1.0, pose.ray_scale / kOwnNoise);
  pose.covariance = shared * shared * covariance_at(scaled, pose, noise);
  return pose;
}

}  // namespace framewise
