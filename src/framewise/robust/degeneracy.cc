// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/degeneracy.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "framewise/solvers/refine_input.h"
#include "framewise/solvers/rotation_npt.h"

namespace framewise {
namespace {

constexpr double kWorstDirection = 6 * M_PI / 180;
// Rays nearer than this to the direction of t feign more information about it than they have.
constexpr double kNearEpipole = 0.2;
constexpr std::size_t kFewestTelling = 8;

struct RotationFit {
  Eigen::Matrix3d R;
  double chi_squared = 0;  // what remains, over its variance 2 sigma^2: both rays have noise
  Eigen::Matrix3d covariance;
};

double squared_difference(const TwoViews& views, const Eigen::Vector3d& predicted, const Bearing& seen) {
  if (views.surface == ImageSurface::kSphere) return (predicted - seen).squaredNorm();
  if (!(predicted.z() > 0)) return 4;
  return (predicted.hnormalized() - seen.hnormalized()).squaredNorm();
}

std::optional<RotationFit> fit_rotation(const TwoViews& views, const Consensus& consensus, double variance) {
  std::vector<Bearing> x1, x2;
  for (const std::uint32_t i : consensus.members) x1.push_back(views.x1[i]), x2.push_back(views.x2[i]);
  const auto R = rotation_npt(x1, x2);
  if (!R) return std::nullopt;
  RotationFit fit{*R, 0, {}};
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < x1.size(); ++k) {
    fit.chi_squared += squared_difference(views, *R * x1[k], x2[k]) / (2 * variance);
    information += Eigen::Matrix3d::Identity() - x1[k] * x1[k].transpose();
  }
  fit.covariance = 2 * variance * information.inverse();
  return fit;
}

bool direction_is_known(const TwoViews& views, const Consensus& consensus) {
  const Pose& pose = consensus.refined.pose;
  std::vector<std::uint32_t> telling = consensus.members;
  std::erase_if(telling,
                [&](std::uint32_t i) { return !(pose.t.cross(pose.R * views.x1[i]).norm() > kNearEpipole); });
  if (telling.size() < kFewestTelling) return false;
  PointColumns pairs;
  fill_ray_pairs(pairs, views.x1, views.x2, views.surface, telling);
  RefineOptions options;
  options.sigma = consensus.sigma;
  options.surface = views.surface;
  const DirectionInformation direction = direction_information(pose, pairs, options);
  const double known = direction.measured - direction.feigned;
  return known > 1 / (kWorstDirection * kWorstDirection) && known > direction.feigned;
}

}  // namespace

bool is_mere_noise(double chi_squared, double n) {
  // chi_squared has mean 2n and variance 4n; that of the noise level adds 8n.
  return chi_squared < 2 * n + 4 * std::sqrt(12 * n);
}

Support what_data_support(const TwoViews& views, const Settled& settled) {
  const Consensus& consensus = settled.consensus;
  Support support{EstimateKind::kFull, consensus.refined.pose, consensus.refined.covariance};
  const double n = static_cast<double>(consensus.members.size());
  const double variance =
      consensus.sigma * consensus.sigma * std::max(consensus.refined.cost / (n - 5), 1e-3);
  const auto rotation = fit_rotation(views, consensus, variance);
  if (rotation && is_mere_noise(rotation->chi_squared, n)) {
    support.kind = EstimateKind::kRotationOnly;
    support.pose = {rotation->R, Eigen::Vector3d::Zero()};
    support.covariance.setConstant(std::numeric_limits<double>::quiet_NaN());
    support.covariance.topLeftCorner<3, 3>() = rotation->covariance;
  } else if (settled.ambiguous || !direction_is_known(views, consensus)) {
    support.kind = EstimateKind::kLowParallax;
  }
  return support;
}

}  // namespace framewise
