// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/rival_minima.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"
#include "framewise/robust/plane_motion.h"
#include "framewise/solvers/refine_input.h"
#include "framewise/solvers/rotation_npt.h"

namespace framewise {
namespace {

constexpr double kCut = 3.2;  // sigmas
constexpr double kSameMinimum = 1e-3;
constexpr double kFarAway = 10 * M_PI / 180;
constexpr double kAsGood = 6;  // times the root of the number of members
constexpr double kFewestInFront = 0.9;

std::vector<Pose> starts(std::span<const Bearing> x1, std::span<const Bearing> x2) {
  std::vector<Pose> poses;
  if (const auto H = robust_plane_homography(x1, x2)) {
    for (const Pose& pose : motions_of_plane(*H)) poses.push_back(pose);
  }
  if (const auto R = rotation_npt(x1, x2)) {
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < x1.size(); ++i) {
      const Eigen::Vector3d n = (*R * x1[i]).cross(x2[i]);
      normals += n * n.transpose();
    }
    const Eigen::Matrix3d directions = symmetric_eigen(normals).vectors;
    for (int k = 0; k < 3; ++k) poses.push_back({*R, directions.col(k)});
  }
  return poses;
}

double motion_between(const Pose& a, const Pose& b) {
  const double turn = rotation_angle(a.R.transpose() * b.R);
  return std::max(turn, std::atan2(a.t.cross(b.t).norm(), a.t.dot(b.t)));
}

// Whatever the sign of t and the rotation of the pair.
bool same_essential(const Pose& a, const Pose& b) {
  const Eigen::Matrix3d A = essential_from_pose(a), B = essential_from_pose(b);
  return std::min((A - B).norm(), (A + B).norm()) < kSameMinimum;
}

struct Minimum {
  Pose pose;
  double cost;
};

}  // namespace

Settled settle_minimum(const TwoViews& views, const Consensus& consensus, double max_error) {
  std::vector<Bearing> x1, x2;
  for (const std::uint32_t i : consensus.members) x1.push_back(views.x1[i]), x2.push_back(views.x2[i]);
  PointColumns pairs;
  fill_ray_pairs(pairs, x1, x2, views.surface);
  RefineOptions refine;
  refine.sigma = consensus.sigma;
  refine.surface = views.surface;
  refine.max_iterations = 15;
  refine.tolerance = 1e-2;

  std::vector<Minimum> minima{
      {consensus.refined.pose, unlikelihood(views, consensus.refined.pose, max_error)}};
  std::size_t best = 0;
  const double margin = kAsGood * std::sqrt(static_cast<double>(consensus.members.size()));
  for (const Pose& start : starts(x1, x2)) {
    if (!start.R.allFinite() || !start.t.allFinite()) continue;
    Minimum minimum{start, unlikelihood(views, start, max_error)};
    const Pose descended = refine_relative_pose(start, pairs, refine).pose;
    const double cost = unlikelihood(views, descended, max_error);
    if (cost < minimum.cost) minimum = {descended, cost};
    if (minimum.cost > minima[best].cost + margin || same_essential(minimum.pose, minima[0].pose)) continue;
    const FrontVote vote = choose_by_parallax(views, minimum.pose, kCut * refine.sigma, max_error);
    if (vote.share < kFewestInFront) continue;
    minima.push_back({vote.pose, minimum.cost});
    if (minimum.cost < minima[best].cost) best = minima.size() - 1;
  }
  Settled settled{consensus, false};
  if (motion_between(minima[best].pose, minima[0].pose) > kSameMinimum) {
    const Consensus other = find_consensus(views, minima[best].pose, max_error);
    if (!other.members.empty()) settled.consensus = other;
  }
  const double limit = minima[best].cost + margin;
  for (const Minimum& minimum : minima) {
    settled.ambiguous |=
        minimum.cost < limit && motion_between(minimum.pose, settled.consensus.refined.pose) > kFarAway;
  }
  return settled;
}

}  // namespace framewise
