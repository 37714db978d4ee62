// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "framewise/geometry/epipolar.h"
#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"
#include "framewise/solvers/refine_relative_pose.h"

namespace framewise {

// The pose that a set of correspondences agrees on, the set, and the noise that it shows.
struct Consensus {
  Refinement refined;
  std::vector<std::uint32_t> members;
  double sigma = 0;  // standard deviation of a residual (pixels / focal length, or rad)
};

// Two views, unit bearings, some of them wrong.
struct TwoViews {
  std::span<const Bearing> x1, x2;
  ImageSurface surface;
};

// Least squares at the scale of the noise: chooses the correspondences within three times the noise, refines
// on them, estimates the noise from them, and again. Starts from the pose of a hypothesis whose inliers have
// Sampson distances below max_error. Empty members when fewer than 8 agree.
//
// Chosen are residuals that are small, points in front of both cameras, and parallaxes not far beyond those
// of the others: in a small motion a wrong match that happens to lie on its epipolar line has a parallax tens
// of times that of the right ones, and would fix the direction of t with that weight.
Consensus find_consensus(const TwoViews& views, const Pose& start, double max_error);

// Of the four poses with the same essential matrix the one with most of the members in front of both cameras,
// each with the weight of its parallax up to max_error: the sign of a smaller one is noise.
struct FrontVote {
  Pose pose;
  double share = 0;  // of the weights
};
FrontVote choose_by_parallax(const TwoViews& views, const Pose& pose, double max_residual, double max_error);

// Sampson's distances of all correspondences from one motion (pixels / focal length, or rad).
class EpipolarDistances {
 public:
  EpipolarDistances(const TwoViews& views, const Pose& pose)
      : views_(views), E_(essential_from_pose(pose)), plane_(views.surface == ImageSurface::kPlane) {}
  double operator[](std::size_t i) const {
    const Bearing &a = views_.x1[i], &b = views_.x2[i];
    const Eigen::Vector3d l2 = E_ * a, l1 = E_.transpose() * b;
    const double r = b.dot(l2);
    // On the planes z = 1 the bearings are a / a.z and b / b.z.
    const double D =
        plane_ ? b.z() * b.z() * l2.head<2>().squaredNorm() + a.z() * a.z() * l1.head<2>().squaredNorm()
               : l2.squaredNorm() + l1.squaredNorm() - 2 * r * r;
    return std::abs(r) / std::sqrt(D);
  }

 private:
  TwoViews views_;
  Eigen::Matrix3d E_;
  bool plane_;
};

// -2 log likelihood of all correspondences: each is right, with Gaussian noise, or wrong, with a residual
// that is anything up to max_error. The noise is what the residuals show, so that a motion which fits many
// points very well wins over one that fits all of them not so well.
double unlikelihood(const TwoViews& views, const Pose& pose, double max_error);

}  // namespace framewise
