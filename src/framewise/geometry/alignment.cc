// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/alignment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace framewise {
namespace {

struct Moments {
  Eigen::Vector3d mean1, mean2;
  Eigen::Matrix3d covariance21;  // of x2 with x1
  double variance1;
};

// One pass. Sums are taken from the first point on, so that a cloud far from its origin loses no digits.
template <typename Weight>
Moments moments(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                const Weight& weight) {
  const Eigen::Vector3d origin1 = X1[0], origin2 = X2[0];
  Eigen::Vector3d s1(0, 0, 0), s2(0, 0, 0), c0(0, 0, 0), c1(0, 0, 0), c2(0, 0, 0);
  double total = 0, square = 0;
  for (std::size_t i = 0; i < X1.size(); ++i) {
    const double w = weight(i);
    const Eigen::Vector3d d1 = X1[i] - origin1, d2 = X2[i] - origin2;
    const Eigen::Vector3d w2 = w * d2;
    total += w;
    s1 += w * d1;
    s2 += w2;
    c0 += d1.x() * w2;
    c1 += d1.y() * w2;
    c2 += d1.z() * w2;
    square += w * d1.squaredNorm();
  }
  Moments m;
  s1 /= total;
  s2 /= total;
  m.mean1 = origin1 + s1;
  m.mean2 = origin2 + s2;
  m.covariance21.col(0) = c0 / total - s1.x() * s2;
  m.covariance21.col(1) = c1 / total - s1.y() * s2;
  m.covariance21.col(2) = c2 / total - s1.z() * s2;
  m.variance1 = square / total - s1.squaredNorm();
  return m;
}

// Turns columns p and q of B = C V until they are orthogonal, V alike. True where there was nothing to turn.
inline bool orthogonalise(Eigen::Matrix3d& B, Eigen::Matrix3d& V, int p, int q) {
  const double a = B.col(p).squaredNorm(), b = B.col(q).squaredNorm(), c = B.col(p).dot(B.col(q));
  if (c * c <= 1e-31 * a * b) return true;
  const double zeta = 0.5 * (b - a);
  const double t = std::copysign(c, zeta * c) / (std::abs(zeta) + std::sqrt(zeta * zeta + c * c));
  const double cosine = 1 / std::sqrt(1 + t * t), sine = cosine * t;
  const Eigen::Vector3d Bp = B.col(p), Vp = V.col(p);
  B.col(p) = cosine * Bp - sine * B.col(q);
  B.col(q) = sine * Bp + cosine * B.col(q);
  V.col(p) = cosine * Vp - sine * V.col(q);
  V.col(q) = sine * Vp + cosine * V.col(q);
  return false;
}

struct RotationFit {
  Eigen::Matrix3d R;
  double trace_DS;  // Umeyama Eq. (42)
};

// One-sided Jacobi: Hestenes 1958. The left vector of the smallest singular value is the cross product of the
// other two, which serves a plane (where it is 0) and picks a rotation over a reflection in one go.
std::optional<RotationFit> fit_rotation(const Eigen::Matrix3d& covariance21) {
  if (!covariance21.allFinite()) return std::nullopt;
  Eigen::Matrix3d B = covariance21, V = Eigen::Matrix3d::Identity();
  for (int sweep = 0; sweep < 30; ++sweep) {
    const bool done01 = orthogonalise(B, V, 0, 1), done02 = orthogonalise(B, V, 0, 2);
    if (orthogonalise(B, V, 1, 2) && done01 && done02) break;
  }
  int first = 0, second = 1, third = 2;
  const Eigen::Vector3d square = B.colwise().squaredNorm();
  if (square[first] < square[second]) std::swap(first, second);
  if (square[second] < square[third]) std::swap(second, third);
  if (square[first] < square[second]) std::swap(first, second);

  const double d0 = std::sqrt(square[first]), d1 = std::sqrt(square[second]);
  if (!(d1 > 1e-12 * d0)) return std::nullopt;
  const Eigen::Vector3d u0 = B.col(first) / d0, u1 = B.col(second) / d1, u2 = u0.cross(u1);
  const Eigen::Vector3d v0 = V.col(first), v1 = V.col(second), v2 = v0.cross(v1);
  const double d2 = u2.dot(B.col(third)) * (v2.dot(V.col(third)) < 0 ? -1 : 1);
  // Points on a line can still turn about it; so can a mirrored cloud with d2 = -d1.
  if (!(d1 + d2 > 1e-12 * d0)) return std::nullopt;
  return RotationFit{u0 * v0.transpose() + u1 * v1.transpose() + u2 * v2.transpose(), d0 + d1 + d2};
}

void check_sizes(std::size_t size1, std::size_t size2, std::size_t weights) {
  if (size1 != size2)
    throw std::invalid_argument("X2 has " + std::to_string(size2) + " points, expected " +
                                std::to_string(size1) + " as X1 has");
  if (weights != 0 && weights != size1)
    throw std::invalid_argument("weights has " + std::to_string(weights) + " entries, expected none or " +
                                std::to_string(size1));
}

}  // namespace

std::optional<Pose> kabsch(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2,
                           std::span<const double> weights) {
  check_sizes(X1.size(), X2.size(), weights.size());
  for (const double w : weights)
    if (!(w >= 0)) throw std::invalid_argument("weights holds " + std::to_string(w) + ", expected 0 or more");
  if (X1.size() < 3) return std::nullopt;
  const Moments m = weights.empty() ? moments(X1, X2, [](std::size_t) { return 1.0; })
                                    : moments(X1, X2, [&](std::size_t i) { return weights[i]; });
  const auto fit = fit_rotation(m.covariance21);
  if (!fit) return std::nullopt;
  return Pose{fit->R, m.mean2 - fit->R * m.mean1};
}

std::optional<Similarity> umeyama(std::span<const Eigen::Vector3d> X1, std::span<const Eigen::Vector3d> X2) {
  check_sizes(X1.size(), X2.size(), 0);
  if (X1.size() < 3) return std::nullopt;
  const Moments m = moments(X1, X2, [](std::size_t) { return 1.0; });
  const auto fit = fit_rotation(m.covariance21);
  if (!fit) return std::nullopt;
  const double scale = fit->trace_DS / m.variance1;
  return Similarity{scale, {fit->R, m.mean2 - scale * fit->R * m.mean1}};
}

}  // namespace framewise
