// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/robust/plane_motion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/geometry/so3.h"
#include "framewise/robust/bearings.h"

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

}  // namespace

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
  std::vector<Bearing> kept1(x1.begin(), x1.end()), kept2(x2.begin(), x2.end());
  std::optional<Eigen::Matrix3d> H = plane_homography(kept1, kept2);
  std::vector<double> residuals(x1.size());
  constexpr int kRounds = 3;
  for (int round = 0; H && round < kRounds; ++round) {
    for (std::size_t i = 0; i < x1.size(); ++i) residuals[i] = (*H * x1[i]).normalized().cross(x2[i]).norm();
    std::vector<double> sorted = residuals;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    kept1.clear(), kept2.clear();
    for (std::size_t i = 0; i < x1.size(); ++i) {
      if (residuals[i] <= 3 * *middle) kept1.push_back(x1[i]), kept2.push_back(x2[i]);
    }
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
