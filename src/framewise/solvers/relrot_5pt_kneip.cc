// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relrot_5pt_kneip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/geometry/so3.h"
#include "framewise/solvers/coplanar_normals.h"
#include "framewise/solvers/matching_sizes.h"
#include "framewise/solvers/rotation_npt.h"
#include "framewise/solvers/rotation_quartics.h"
#include "framewise/solvers/small_eigenvalues.h"

namespace framewise {
namespace {

using Rotations = Hypotheses<Eigen::Matrix3d, 20>;
using Five = std::array<Bearing, 5>;

// The problem in the frames we solve it in: x1 turned by the best pure rotation, both by a fixed rotation, so
// that no axis of the cameras is an axis of the unknowns. What is left to find is q = (1, scale a, scale b,
// scale c).
struct Gauge {
  Five f, g;
  Eigen::Matrix3d f_from_x1, g_from_x2;
  double scale;

  Gauge(const Five& x1, const Five& x2) {
    static const Eigen::Matrix3d kTurn = so3_exp(Eigen::Vector3d(0.7, -1.1, 0.4));
    g_from_x2 = kTurn;
    f_from_x1 = kTurn * rotation_npt(x1, x2).value_or(Eigen::Matrix3d::Identity());
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      f[i] = f_from_x1 * x1[i];
      g[i] = g_from_x2 * x2[i];
      sum += (f[i] - g[i]).squaredNorm();
    }
    scale = std::clamp(std::sqrt(sum / 5), 1e-9, 1.0);
  }
};

// [q, (A_1 + 1) q, ..., (A_5 + 1) q], of the same rank as [q, A_1 q, ..., A_5 q] and with small first rows
// when f and g almost agree. Row 0 is divided by scale^2, rows 1 to 3 by scale, column 0 multiplied by
// scale^2.
LinearForms linear_forms(const Gauge& gauge) {
  const double s = gauge.scale;
  LinearForms m = {};
  m.form[0][0][0] = 1;
  for (int r = 1; r < 4; ++r) m.form[r][0][r] = s * s;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d &f = gauge.f[i], &g = gauge.g[i];
    const double half_distance2 = 0.5 * (f - g).squaredNorm();  // 1 - f.g
    const Eigen::Vector3d n = g.cross(f) / s;
    m.form[0][i + 1][0] = half_distance2 / (s * s);
    for (int r = 0; r < 3; ++r) {
      m.form[0][i + 1][r + 1] = m.form[r + 1][i + 1][0] = n[r];
      for (int k = 0; k < 3; ++k) m.form[r + 1][i + 1][k + 1] = -(g[r] * f[k] + f[r] * g[k]);
      m.form[r + 1][i + 1][r + 1] += 2 - half_distance2;
    }
  }
  return m;
}

// Multiplication by a in the basis of the 20 monomials up to degree 3: M v = a v for their values v at a
// solution. False when the quartics do not fix the monomials of degree 4.
bool action_matrix(double (&quartics)[15][35], double (&M)[20][20]) {
  // Elimination order of the monomials of degree 4: first the five without a, which the action does not need.
  constexpr int kFirst = 20, kWithA = 10;
  const auto column = [](int k) { return k < 5 ? kFirst + kWithA + k : kFirst + k - 5; };
  for (int k = 0; k < 15; ++k) {
    const int c = column(k);
    int pivot = k;
    for (int i = k + 1; i < 15; ++i)
      if (std::abs(quartics[i][c]) > std::abs(quartics[pivot][c])) pivot = i;
    if (!(std::abs(quartics[pivot][c]) > 1e-300)) return false;
    if (pivot != k) std::swap_ranges(quartics[k], quartics[k] + 35, quartics[pivot]);
    const double inverse = 1 / quartics[k][c];
    const int end = k < 5 ? 35 : 30;
    for (int j = 0; j < end; ++j) quartics[k][j] *= inverse;
    for (int i = k + 1; i < 15; ++i) {
      const double factor = quartics[i][c];
      for (int j = 0; j < end; ++j) quartics[i][j] -= factor * quartics[k][j];
    }
  }
  for (int k = 14; k > 5; --k)
    for (int i = 5; i < k; ++i) {
      const double factor = quartics[i][column(k)];
      for (int j = 0; j < 20; ++j) quartics[i][j] -= factor * quartics[k][j];
    }
  for (int m = 0; m < 20; ++m) {
    const int* p = kMonomials.power[m];
    const int raised = kMonomials.index[p[0] + 1][p[1]][p[2]];
    for (int j = 0; j < 20; ++j) M[m][j] = raised < kFirst ? j == raised : -quartics[5 + raised - kFirst][j];
  }
  return true;
}

// The real eigenvalues, those of the least rotation first, then complex pairs so close to the real axis that
// they may be a double root.
struct Candidates {
  double a[20];
  bool explained[20] = {};
  int size = 0, real = 0;

  explicit Candidates(const SmallEigenvalues<20, 4>& eigen) {
    const auto by_size = [](double x, double y) { return std::abs(x) < std::abs(y); };
    for (int i = 0; i < 20; ++i)
      if (eigen.imag(i) == 0) a[size++] = eigen.real(i);
    std::sort(a, a + size, by_size);
    real = size;
    for (int i = 0; i < 20; ++i)
      if (eigen.imag(i) > 0 && eigen.imag(i) < 1e-3 * (std::abs(eigen.real(i)) + 1e-3))
        a[size++] = eigen.real(i);
  }

  // A rotation already found takes its eigenvalue out.
  void explain(const Eigen::Matrix3d& R, double scale) {
    const Eigen::Quaterniond q(R);
    const double a_of_R = q.x() / (scale * q.w());
    int nearest = 0;
    for (int i = 1; i < real; ++i)
      if (std::abs(a[i] - a_of_R) < std::abs(a[nearest] - a_of_R)) nearest = i;
    if (std::abs(a[nearest] - a_of_R) < 1e-4 * std::abs(a_of_R)) explained[nearest] = true;
  }
};

// The other rotation with the same epipolar planes, (2 t t' - I) R.
Eigen::Matrix3d twin(const RotationAndDirection& s) { return 2 * s.t * (s.t.transpose() * s.R) - s.R; }

bool contains(const Rotations& rotations, const Eigen::Matrix3d& R, double tolerance) {
  // |R - Q| is 2 sqrt(2) sin(angle / 2)
  return std::any_of(rotations.begin(), rotations.end(), [&](const Eigen::Matrix3d& Q) {
    return (R - Q).squaredNorm() < 2 * tolerance * tolerance;
  });
}

Rotations solve(const Gauge& gauge) {
  Rotations rotations;
  double quartics[15][35], M[20][20];
  quartic_minors(linear_forms(gauge), quartics);
  SmallEigenvalues<20, 4> eigen;
  if (!action_matrix(quartics, M) || !eigen.compute(M)) return rotations;

  Candidates candidates(eigen);
  for (int k = 0; k < candidates.size; ++k) {
    // Both rotations of every pair are eigenvalues: one finds the other.
    if (candidates.explained[k]) continue;
    if (k < candidates.real && rotations.size() >= static_cast<std::size_t>(candidates.real)) continue;
    if (rotations.size() + 2 > rotations.capacity()) break;
    double v[4];
    eigen.eigenvector(candidates.a[k], v);
    const Eigen::Vector3d abc = Eigen::Vector3d(v[1], v[2], v[3]) / v[0];
    if (!abc.allFinite()) continue;
    const Eigen::Vector3d vec = gauge.scale * abc;
    RotationAndDirection start;
    start.R = Eigen::Quaterniond(1, vec.x(), vec.y(), vec.z()).normalized().toRotationMatrix();
    if (contains(rotations, start.R, 1e-6 * gauge.scale)) continue;
    start.t = common_normal(gauge.f, gauge.g, start.R);
    const auto found = polish_coplanar_normals(gauge.f, gauge.g, start, gauge.scale);
    if (!found || contains(rotations, found->R, 1e-7 * gauge.scale)) continue;
    rotations.push_back(found->R);
    rotations.push_back(twin(*found));
    candidates.explain(rotations[rotations.size() - 1], gauge.scale);
  }
  return rotations;
}

}  // namespace

Rotations relrot_5pt_kneip(const Five& x1, const Five& x2) {
  const Gauge gauge(x1, x2);
  Rotations rotations = solve(gauge);
  for (Eigen::Matrix3d& R : rotations) R = gauge.g_from_x2.transpose() * R * gauge.f_from_x1;
  return rotations;
}

Rotations relrot_5pt_kneip(std::span<const Bearing> x1, std::span<const Bearing> x2) {
  check_matching_sizes("relrot_5pt_kneip", x1.size(), x2.size());
  if (x1.size() < 5 || x1.size() > 8)
    throw std::invalid_argument("relrot_5pt_kneip: x1 has " + std::to_string(x1.size()) +
                                " bearings, expected 5 to 8");
  Five first1, first2;
  std::copy_n(x1.begin(), 5, first1.begin());
  std::copy_n(x2.begin(), 5, first2.begin());
  const Rotations from_five = relrot_5pt_kneip(first1, first2);
  if (x1.size() == 5) return from_five;

  const double reach = Gauge(first1, first2).scale;
  Hypotheses<RotationAndDirection, 10> refined;
  for (std::size_t i = 0; i < from_five.size(); i += 2) {
    const RotationAndDirection start{from_five[i], common_normal(first1, first2, from_five[i])};
    if (const auto found = polish_coplanar_normals(x1, x2, start, reach)) refined.push_back(*found);
  }
  std::sort(refined.begin(), refined.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  Rotations rotations;
  for (const RotationAndDirection& found : refined) {
    rotations.push_back(found.R);
    rotations.push_back(twin(found));
  }
  return rotations;
}

}  // namespace framewise
