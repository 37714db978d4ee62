// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/plane_motion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"
#include "framewise/robust/bearings.h"
#include "framewise/robust/sampler.h"

namespace framewise {
namespace {

// Ma et al., Eq. (5.44)-(5.45), for one of the two frames {v2, u, v2 x u} that H turns rigidly.
Pose motion_of_frame(const Eigen::Matrix3d& H, const Eigen::Vector3d& v2, const Eigen::Vector3d& u) {
  Eigen::Matrix3d U, W;
  const Eigen::Vector3d Hv2 = H * v2, Hu = H * u, normal = v2.cross(u);
  U << v2, u, normal;
  W << Hv2, Hu, Hv2.cross(Hu);
  const Eigen::Matrix3d R = nearest_rotation(W * U.transpose());
  return {R, ((H - R) * normal).normalized()};
}

constexpr int kSamples = 40;  // with a fifth of the points elsewhere, 1 run in 10^9 draws none on the plane
constexpr std::size_t kEnough = 50;  // points tell one plane from another

// |sine| of the angle between x2 and where H takes x1, squared.
double squared_residual(const Eigen::Matrix3d& H, const Bearing& x1, const Bearing& x2) {
  const Eigen::Vector3d y = H * x1;
  const double along = y.dot(x2);
  return 1 - along * along / y.squaredNorm();
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The frame of projective coordinates in which points 0, 1, 2 are the axes and point 3 is their sum.
std::optional<Eigen::Matrix3d> projective_frame(std::span<const Bearing, 4> x) {
  Eigen::Matrix3d A;
  A << x[0], x[1], x[2];
  const double volume = A.determinant();
  if (!(std::abs(volume) > 1e-12)) return std::nullopt;
  const Eigen::Vector3d sums{x[3].cross(x[1]).dot(x[2]), x[0].cross(x[3]).dot(x[2]),
                             x[0].cross(x[1]).dot(x[3])};
  if (!(sums.cwiseAbs().minCoeff() > 1e-12)) return std::nullopt;
  return Eigen::Matrix3d(A * (sums / volume).asDiagonal());
}

}  // namespace

std::optional<Eigen::Matrix3d> homography_4pt(std::span<const Bearing, 4> x1,
                                              std::span<const Bearing, 4> x2) {
  const auto frame1 = projective_frame(x1), frame2 = projective_frame(x2);
  if (!frame1 || !frame2) return std::nullopt;
  return Eigen::Matrix3d(*frame2 * frame1->inverse());
}

std::optional<Eigen::Matrix3d> plane_homography(std::span<const Bearing> x1, std::span<const Bearing> x2) {
  if (x1.size() < 4) return std::nullopt;
  // x2 x (H x1) = 0: with N = I - x2 x2' the normal matrix of vec(H), row-major, is the sum of N (x) x1 x1'.
  Eigen::Matrix<double, 9, 9> M = Eigen::Matrix<double, 9, 9>::Zero();
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const Eigen::Matrix3d N = Eigen::Matrix3d::Identity() - x2[i] * x2[i].transpose();
    const Eigen::Matrix3d P = x1[i] * x1[i].transpose();
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c <= r; ++c) M.block<3, 3>(3 * r, 3 * c) += N(r, c) * P;
    }
  }
  const SymmetricEigen<9> eigen = symmetric_eigen(M);
  if (!(eigen.values[1] > 1e-12 * eigen.values[8])) return std::nullopt;
  const Eigen::Matrix<double, 9, 1> h = eigen.vectors.col(0);
  Eigen::Matrix3d H = Eigen::Map<const RowMajor3d>(h.data());
  const SymmetricEigen<3> squared = symmetric_eigen(Eigen::Matrix3d(H.transpose() * H));
  const double middle = std::sqrt(std::max(squared.values[1], 0.0));
  if (!(middle > 0)) return std::nullopt;
  double sign = 0;
  for (std::size_t i = 0; i < x1.size(); ++i) sign += x2[i].dot(H * x1[i]);
  return Eigen::Matrix3d(H * ((sign < 0 ? -1 : 1) / middle));
}

std::optional<Eigen::Matrix3d> robust_plane_homography(std::span<const Bearing> x1,
                                                       std::span<const Bearing> x2) {
  if (x1.size() < 4) return std::nullopt;
  // The median over every `stride`-th point.
  std::vector<double> residuals;
  const auto measure = [&](const Eigen::Matrix3d& H, std::size_t stride) {
    residuals.clear();
    for (std::size_t i = 0; i < x1.size(); i += stride)
      residuals.push_back(squared_residual(H, x1[i], x2[i]));
    return median(residuals);
  };

  std::optional<Eigen::Matrix3d> H;
  double least = std::numeric_limits<double>::infinity();
  RandomStream random(x1.size());
  for (int sample = 0; sample < kSamples; ++sample) {
    std::array<std::uint32_t, 4> at{};
    draw_distinct(x1.size(), at, random);
    const std::array<Bearing, 4> a{x1[at[0]], x1[at[1]], x1[at[2]], x1[at[3]]},
        b{x2[at[0]], x2[at[1]], x2[at[2]], x2[at[3]]};
    const auto drawn = homography_4pt(a, b);
    if (!drawn) continue;
    const double found = measure(*drawn, std::max<std::size_t>(1, x1.size() / kEnough));
    if (found < least) H = drawn, least = found;
  }

  constexpr int kRounds = 2;
  for (int round = 0; H && round < kRounds; ++round) {
    const double limit = 9 * measure(*H, 1);
    std::vector<Bearing> kept1, kept2;
    for (std::size_t i = 0; i < x1.size(); ++i)
      if (squared_residual(*H, x1[i], x2[i]) <= limit) kept1.push_back(x1[i]), kept2.push_back(x2[i]);
    H = plane_homography(kept1, kept2);
  }
  return H;
}

Hypotheses<Pose, 2> motions_of_plane(const Eigen::Matrix3d& H) {
  Hypotheses<Pose, 2> motions;
  const SymmetricEigen<3> eigen = symmetric_eigen(Eigen::Matrix3d(H.transpose() * H));
  const double s1 = eigen.values[2], s3 = eigen.values[0];  // squared singular values
  if (!(s1 - s3 > 1e-9)) return motions;
  const Eigen::Vector3d v1 = eigen.vectors.col(2), v2 = eigen.vectors.col(1), v3 = eigen.vectors.col(0);
  const double a = std::sqrt(std::max(0.0, 1 - s3) / (s1 - s3)),
               b = std::sqrt(std::max(0.0, s1 - 1) / (s1 - s3));
  motions.push_back(motion_of_frame(H, v2, a * v1 + b * v3));
  motions.push_back(motion_of_frame(H, v2, a * v1 - b * v3));
  return motions;
}

}  // namespace framewise
