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
// Times the root of the number of members. The two motions of a plane share all its points, and chance
// outliers on the epipolar lines of one of them speak louder than the difference.
constexpr double kAsGood = 2, kAsGoodOnPlane = 4;
constexpr double kFewestInFront = 0.9;

struct Start {
  Pose pose;
  double as_good;
};

std::vector<Start> starts(std::span<const Bearing> x1, std::span<const Bearing> x2) {
  std::vector<Start> found;
  if (const auto H = robust_plane_homography(x1, x2)) {
    for (const Pose& pose : motions_of_plane(*H)) found.push_back({pose, kAsGoodOnPlane});
  }
  if (const auto R = rotation_npt(x1, x2)) {
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < x1.size(); ++i) {
      const Eigen::Vector3d n = (*R * x1[i]).cross(x2[i]);
      normals += n * n.transpose();
    }
    const Eigen::Matrix3d directions = symmetric_eigen(normals).vectors;
    for (int k = 0; k < 3; ++k) found.push_back({{*R, directions.col(k)}, kAsGood});
  }
  return found;
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
  double margin;  // no worse than the best by more than this: as good
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
  refine.tolerance = 0.1;              // nothing beside the margins
  refine.loss = {Loss::kCauchy, 2.0};  // members of one minimum are in part outliers of another

  std::vector<Minimum> minima{
      {consensus.refined.pose, unlikelihood(views, consensus.refined.pose, max_error), 0}};
  std::size_t best = 0;
  const auto consider = [&](const Pose& pose, double as_good) {
    const double cost = unlikelihood(views, pose, max_error);
    const double margin = as_good * std::sqrt(static_cast<double>(consensus.members.size()));
    if (cost > minima[best].cost + margin || same_essential(pose, minima[0].pose)) return;
    const FrontVote vote = choose_by_parallax(views, pose, kCut * refine.sigma, max_error);
    if (vote.share < kFewestInFront) return;
    minima.push_back({vote.pose, cost, margin});
    if (cost < minima[best].cost) best = minima.size() - 1;
  };
  for (const auto& [start, as_good] : starts(x1, x2)) {
    if (!start.R.allFinite() || !start.t.allFinite()) continue;
    // A start may lie in the same flat valley as the first minimum and be as likely, far away from it.
    consider(start, as_good);
    consider(refine_relative_pose(start, pairs, refine).pose, as_good);
  }
  Settled settled{consensus, false};
  if (motion_between(minima[best].pose, minima[0].pose) > kSameMinimum) {
    const Consensus other = find_consensus(views, minima[best].pose, max_error);
    if (!other.members.empty()) settled.consensus = other;
  }
  for (const Minimum& minimum : minima) {
    settled.ambiguous |= minimum.cost < minima[best].cost + minimum.margin &&
                         motion_between(minimum.pose, settled.consensus.refined.pose) > kFarAway;
  }
  return settled;
}

}  // namespace framewise
