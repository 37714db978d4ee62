// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/coplanar_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// Solves A x = b in place by elimination with row pivoting, x in b. False when a pivot vanishes.
bool solve5(double (&A)[5][6]) {
  for (int k = 0; k < 5; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 5; ++i)
      if (std::abs(A[i][k]) > std::abs(A[pivot][k])) pivot = i;
    if (!(std::abs(A[pivot][k]) > 0)) return false;
    if (pivot != k) std::swap_ranges(A[k], A[k] + 6, A[pivot]);
    const double inverse = 1 / A[k][k];
    for (int j = k + 1; j < 6; ++j) A[k][j] *= inverse;
    for (int i = k + 1; i < 5; ++i)
      for (int j = k + 1; j < 6; ++j) A[i][j] -= A[i][k] * A[k][j];
  }
  for (int k = 4; k > 0; --k)
    for (int i = 0; i < k; ++i) A[i][5] -= A[i][k] * A[k][5];
  return true;
}

struct Row {
  double j[6];  // derivatives by rotation (3) and direction (2), and minus the residual
};

Row linearise(const Bearing& x1, const Bearing& x2, const RotationAndDirection& s, const Eigen::Vector3d& b1,
              const Eigen::Vector3d& b2) {
  const Eigen::Vector3d h = s.R * x1, n = x2.cross(h), w = h.cross(s.t.cross(x2));
  return {{w.x(), w.y(), w.z(), b1.dot(n), b2.dot(n), -s.t.dot(n)}};
}

}  // namespace

Eigen::Vector3d common_normal(std::span<const Bearing> x1, std::span<const Bearing> x2,
                              const Eigen::Matrix3d& R) {
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const Eigen::Vector3d n = x2[i].cross(R * x1[i]);
    M.noalias() += n * n.transpose();
  }
  // M is nearly of rank 2: the columns of its adjugate are multiples of t.
  const Eigen::Vector3d c[3] = {M.col(1).cross(M.col(2)), M.col(2).cross(M.col(0)), M.col(0).cross(M.col(1))};
  int k = c[1][1] > c[0][0];
  if (c[2][2] > c[k][k]) k = 2;
  return c[k].normalized();
}

std::optional<RotationAndDirection> polish_coplanar_normals(std::span<const Bearing> x1,
                                                            std::span<const Bearing> x2,
                                                            const RotationAndDirection& start, double reach,
                                                            std::span<const double> weights) {
  RotationAndDirection s = start;
  // More bearings than unknowns do not fit when there is noise, and there Gauss-Newton gains a digit at a
  // time.
  const bool fits = x1.size() <= 5;
  const int max_iterations = fits ? 12 : 40;
  bool nearly_settled = false;
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const Eigen::Vector3d b1 = s.t.unitOrthogonal(), b2 = s.t.cross(b1);
    double A[5][6] = {};
    s.cost = 0;
    for (std::size_t i = 0; i < x1.size(); ++i) {
      const Row row = linearise(x1[i], x2[i], s, b1, b2);
      const double w = weights.empty() ? 1.0 : weights[i];
      s.cost += w * row.j[5] * row.j[5];
      if (x1.size() == 5)
        std::copy_n(row.j, 6, A[i]);
      else
        for (int k = 0; k < 5; ++k)
          for (int l = 0; l < 6; ++l) A[k][l] += w * row.j[k] * row.j[l];
    }
    if (!solve5(A)) return std::nullopt;
    Eigen::Vector3d turn(A[0][5], A[1][5], A[2][5]);
    double turn_norm = turn.norm(), shift = std::hypot(A[3][5], A[4][5]);
    if (!std::isfinite(turn_norm + shift)) return std::nullopt;
    const double step = std::min({1.0, 0.5 * reach / turn_norm, 0.5 / shift});
    s.R = so3_exp(step * turn) * s.R;
    s.t = (s.t + step * (A[3][5] * b1 + A[4][5] * b2)).normalized();
    // Newton doubles the digits: what is left after such a step is rounding.
    if (turn_norm < 1e-8 * reach && shift < 1e-8) return s;
    nearly_settled = turn_norm < 1e-3 * reach && shift < 1e-3;
  }
  if (!fits && nearly_settled) return s;
  return std::nullopt;
}

}  // namespace framewise
