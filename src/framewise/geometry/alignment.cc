// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/alignment.h"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace framewise {
namespace {

struct Moments {
  Eigen::Vector3d mean1, mean2;
  Eigen::Matrix3d covariance21;  // of x2 with x1
  double variance1;
};

Moments moments(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                std::span<const double> weights) {
  Moments m{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0};
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  double total = 0;
  for (std::size_t i = 0; i < X1.size(); ++i) {
    m.mean1 += weight(i) * X1[i];
    m.mean2 += weight(i) * X2[i];
    total += weight(i);
  }
  m.mean1 /= total;
  m.mean2 /= total;
  for (std::size_t i = 0; i < X1.size(); ++i) {
    const Eigen::Vector3d d1 = X1[i] - m.mean1;
    m.covariance21 += (weight(i) / total) * (X2[i] - m.mean2) * d1.transpose();
    m.variance1 += (weight(i) / total) * d1.squaredNorm();
  }
  return m;
}

struct RotationFit {
  Eigen::Matrix3d R;
  double trace_DS;  // Umeyama Eq. (42)
};

std::optional<RotationFit> fit_rotation(const Eigen::Matrix3d& covariance21) {
  if (!covariance21.allFinite()) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance21, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d D = svd.singularValues();
  // Rank 1 or 0: points on a line can still turn about it.
  if (!(D[1] > 1e-12 * D[0])) return std::nullopt;
  Eigen::Vector3d S(1, 1, svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1);
  return RotationFit{svd.matrixU() * S.asDiagonal() * svd.matrixV().transpose(), D.dot(S)};
}

}  // namespace

std::optional<Pose> kabsch(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                           std::span<const double> weights) {
  if (X1.size() < 3) return std::nullopt;
  const Moments m = moments(X1, X2, weights);
  const auto fit = fit_rotation(m.covariance21);
  if (!fit) return std::nullopt;
  return Pose{fit->R, m.mean2 - fit->R * m.mean1};
}

std::optional<Similarity> umeyama(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2) {
  if (X1.size() < 3) return std::nullopt;
  const Moments m = moments(X1, X2, {});
  const auto fit = fit_rotation(m.covariance21);
  if (!fit) return std::nullopt;
  const double scale = fit->trace_DS / m.variance1;
  return Similarity{scale, {fit->R, m.mean2 - scale * fit->R * m.mean1}};
}

}  // namespace framewise
