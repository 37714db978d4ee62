// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/consensus.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "framewise/geometry/epipolar.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/refine_input.h"

namespace framewise {
namespace {

constexpr std::size_t kFewest = 8;
constexpr double kCut = 3.2;        // sigmas; Gaussian noise loses 0.14 % of its inliers
constexpr double kFarParallax = 4;  // times the parallax that nine in ten of the members stay below
constexpr double kMedianToSigma = 1 / 0.6745;

double quantile(std::vector<double> values, double q) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void choose_members(const TwoViews& views, const Pose& pose, double max_distance, double max_error,
                    std::vector<std::uint32_t>& members) {
  members.clear();
  std::vector<double> parallaxes;
  const EpipolarDistances distances(views, pose);
  const double unsure = 2 * max_error;  // a parallax this small may have either sign
  for (std::uint32_t i = 0; i < views.x1.size(); ++i) {
    if (!(distances[i] < max_distance)) continue;
    const double parallax = (pose.R * views.x1[i]).cross(views.x2[i]).norm();
    if (parallax > unsure && !in_front_of_both(pose, views.x1[i], views.x2[i])) continue;
    members.push_back(i);
    parallaxes.push_back(parallax);
  }
  if (members.empty()) return;
  const double most = kFarParallax * quantile(parallaxes, 0.9) + unsure;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (parallaxes[k] <= most) members[kept++] = members[k];
  }
  members.resize(kept);
}

double noise_of(const TwoViews& views, const Pose& pose, std::span<const std::uint32_t> members) {
  const EpipolarDistances all(views, pose);
  std::vector<double> distances;
  for (const std::uint32_t i : members) distances.push_back(all[i]);
  constexpr double kLeast = 1e-9;  // exact data have no noise to divide by
  return std::max(kMedianToSigma * quantile(distances, 0.5), kLeast);
}

}  // namespace

Consensus find_consensus(const TwoViews& views, const Pose& start, double max_error) {
  Consensus consensus;
  consensus.refined.pose = start;
  RefineOptions refine;
  refine.surface = views.surface;
  refine.max_iterations = 10;
  refine.tolerance = 1e-4;
  PointColumns pairs;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const Pose pose = consensus.refined.pose;
    choose_members(views, pose, max_error, max_error, consensus.members);
    if (consensus.members.size() < kFewest) break;
    consensus.sigma = noise_of(views, pose, consensus.members);
    // The first pose is not good enough to be strict.
    const double widest = round == 0 ? 0.7 * max_error : 0;
    choose_members(views, pose, std::min(max_error, std::max(widest, kCut * consensus.sigma)), max_error,
                   consensus.members);
    if (consensus.members.size() < kFewest) break;
    refine.sigma = consensus.sigma;
    fill_ray_pairs(pairs, views.x1, views.x2, views.surface, consensus.members);
    consensus.refined = refine_relative_pose(pose, pairs, refine);
  }
  if (consensus.members.size() < kFewest) consensus.members.clear();
  return consensus;
}

FrontVote choose_by_parallax(const TwoViews& views, const Pose& pose, double max_residual, double max_error) {
  const auto poses = decompose_essential(essential_from_pose(pose));
  const EpipolarDistances distances(views, pose);
  std::array<double, 4> votes{};
  double sum = 0;
  for (std::size_t i = 0; i < views.x1.size(); ++i) {
    if (!(distances[i] < max_residual)) continue;
    double most = 0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (!in_front_of_both(poses[k], views.x1[i], views.x2[i])) continue;
      const double parallax = (poses[k].R * views.x1[i]).cross(views.x2[i]).norm();
      const double weight = std::min(1.0, parallax / max_error);
      votes[k] += weight;
      most = std::max(most, weight);
    }
    sum += most;
  }
  const auto best = std::max_element(votes.begin(), votes.end());
  return {poses[static_cast<std::size_t>(best - votes.begin())], sum > 0 ? *best / sum : 0};
}

double unlikelihood(const TwoViews& views, const Pose& pose, double max_error) {
  constexpr double kRight = 0.8;
  const EpipolarDistances distances(views, pose);
  std::vector<double> residuals(views.x1.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] = distances[i] / max_error;
  const double median_sigma = kMedianToSigma * quantile(residuals, 0.5);
  double least = std::numeric_limits<double>::infinity();
  for (const double factor : {1.0, 1.6, 2.6}) {
    const double sigma = std::clamp(factor * median_sigma, 1e-6, 0.5);
    const double right = kRight * 2 / (std::sqrt(2 * M_PI) * sigma), exponent = -0.5 / (sigma * sigma);
    double cost = 0, product = 1;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      product *= right * std::exp(exponent * residuals[i] * residuals[i]) + 1 - kRight;
      if (i % 8 != 7) continue;  // a logarithm for eight
      cost -= 2 * std::log(product);
      product = 1;
    }
    least = std::min(least, cost - 2 * std::log(product));
  }
  return least;
}

}  // namespace framewise
