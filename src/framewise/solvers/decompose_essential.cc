// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/decompose_essential.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// Right-handed frames with E = U diag(s1, s2, +-s3) V', s1 >= s2 >= s3.
struct SingularFrames {
  Eigen::Matrix3d U, V;
};

// Turns columns i and j of B (and V) so that those of B become orthogonal. Returns false if they were.
bool orthogonalise(Eigen::Matrix3d& B, Eigen::Matrix3d& V, int i, int j) {
  const double a = B.col(i).squaredNorm(), b = B.col(j).squaredNorm(), c = B.col(i).dot(B.col(j));
  if (!(std::abs(c) > std::numeric_limits<double>::epsilon() * std::sqrt(a * b))) return false;
  const double zeta = (b - a) / (2 * c);
  const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
  const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
  for (Eigen::Matrix3d* M : {&B, &V}) {
    const Eigen::Vector3d mi = M->col(i);
    M->col(i) = cosine * mi - sine * M->col(j);
    M->col(j) = sine * mi + cosine * M->col(j);
  }
  return true;
}

// One-sided Jacobi rotations (Golub and Van Loan, Matrix Computations, section 8.6.3): E V = U S.
SingularFrames singular_frames(const Eigen::Matrix3d& E) {
  Eigen::Matrix3d B = E, V = Eigen::Matrix3d::Identity();
  for (int sweep = 0; sweep < 12; ++sweep) {
    bool turned = orthogonalise(B, V, 0, 1);
    turned |= orthogonalise(B, V, 0, 2);
    turned |= orthogonalise(B, V, 1, 2);
    if (!turned) break;
  }
  double s[3] = {B.col(0).norm(), B.col(1).norm(), B.col(2).norm()};
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
    if (s[i] >= s[j]) continue;
    std::swap(s[i], s[j]);
    B.col(i).swap(B.col(j));
    V.col(i).swap(V.col(j));
  }
  SingularFrames frames;
  frames.V << V.col(0), V.col(1), V.col(0).cross(V.col(1));
  const Eigen::Vector3d u0 = s[0] > 0 ? Eigen::Vector3d(B.col(0) / s[0]) : Eigen::Vector3d::UnitX();
  // A second singular value lost in rounding leaves its direction free.
  const Eigen::Vector3d u1 = s[1] > 1e-15 * s[0]
                                 ? Eigen::Vector3d(B.col(1) - u0 * u0.dot(B.col(1))).normalized()
                                 : u0.unitOrthogonal();
  frames.U << u0, u1, u0.cross(u1);
  return frames;
}

}  // namespace

Eigen::Matrix3d nearest_essential(const Eigen::Matrix3d& M) {
  const auto [U, V] = singular_frames(M);
  return U.leftCols<2>() * V.leftCols<2>().transpose();
}

std::array<Pose, 4> decompose_essential(const Eigen::Matrix3d& E) {
  const auto [U, V] = singular_frames(E);
  // R = U W V' and U W' V' with W a quarter turn about z.
  const Eigen::Matrix3d u2v2 = U.col(2) * V.col(2).transpose();
  const Eigen::Matrix3d turn = U.col(1) * V.col(0).transpose() - U.col(0) * V.col(1).transpose();
  const Eigen::Matrix3d Ra = u2v2 + turn, Rb = u2v2 - turn;
  const Eigen::Vector3d t = U.col(2);
  return {Pose{Ra, t}, Pose{Ra, -t}, Pose{Rb, t}, Pose{Rb, -t}};
}

std::optional<CheiralityVote> choose_by_cheirality(const Eigen::Matrix3d& E, std::span<const Bearing> x1,
                                                   std::span<const Bearing> x2) {
  if (x1.size() != x2.size()) {
    throw std::invalid_argument("choose_by_cheirality: x1 has " + std::to_string(x1.size()) +
                                " bearings, x2 has " + std::to_string(x2.size()) + "; expected as many");
  }
  if (!E.allFinite()) return std::nullopt;
  const std::array<Pose, 4> poses = decompose_essential(E);
  std::array<std::size_t, 4> votes{};
  for (std::size_t i = 0; i < x1.size(); ++i) {
    for (int k = 0; k < 4; k += 2) {  // t and -t change both signs
      const Eigen::Vector3d Rx1 = poses[k].R * x1[i];
      const Eigen::Vector3d n = Rx1.cross(x2[i]);
      const double lambda1 = x2[i].cross(poses[k].t).dot(n), lambda2 = Rx1.cross(poses[k].t).dot(n);
      votes[k] += lambda1 > 0 && lambda2 > 0;
      votes[k + 1] += lambda1 < 0 && lambda2 < 0;
    }
  }
  const std::size_t best = std::max_element(votes.begin(), votes.end()) - votes.begin();
  if (votes[best] == 0) return std::nullopt;
  return CheiralityVote{poses[best], votes[best]};
}

}  // namespace framewise
