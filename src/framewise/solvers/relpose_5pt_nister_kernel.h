// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/solvers/five_point_kernel.h"
#include "framewise/solvers/real_roots_kernel.h"

// Nister, An Efficient Solution to the Five-Point Relative Pose Problem, PAMI 2004. Names and equations are
// his.
namespace framewise::five_point::FRAMEWISE_ISA {

// Nister's ten pivots, those with x first: they are the well-determined ones where the parallax is small (see
// align). Then his ten columns: x (z^2 z 1), y (z^2 z 1), (z^3 z^2 z 1).
inline constexpr int kNisterOrder[20] = {0, 1,  2,  4, 10, 5,  11, 3,  6,  12,
                                         7, 13, 16, 8, 14, 17, 9,  15, 18, 19};
// Where the pivots of his rows e, f, g, h, i, j stand: x2z x2 y2z y2 xyz xy.
inline constexpr int kRowsEToJ[6] = {3, 4, 8, 9, 5, 6};

// The 3 x 3 matrix B(z) of polynomials, lowest power first: B(z) (x, y, 1)' = 0. Eq. (18) to (24).
struct HiddenVariable {
  double x[3][4], y[3][4], one[3][5];
};

FRAMEWISE_INLINE HiddenVariable hide_z(const Constraints& system, const int (&slots)[10],
                                       const double (&pivots)[10]) {
  double rows[6][10];
  for (int r = 0; r < 6; ++r) {
    const double inverse = 1 / pivots[kRowsEToJ[r]];
    for (int c = 0; c < 10; ++c) {
      rows[r][c] = inverse * element(system.column[kNisterOrder[10 + c]], slots[kRowsEToJ[r]]);
    }
  }
  HiddenVariable B;
  for (int r = 0; r < 3; ++r) {  // k = e - z f, l = g - z h, m = i - z j
    const double *e = rows[2 * r], *f = rows[2 * r + 1];
    const double x[4] = {e[2], e[1] - f[2], e[0] - f[1], -f[0]};
    const double y[4] = {e[5], e[4] - f[5], e[3] - f[4], -f[3]};
    const double one[5] = {e[9], e[8] - f[9], e[7] - f[8], e[6] - f[7], -f[6]};
    std::memcpy(B.x[r], x, sizeof x);
    std::memcpy(B.y[r], y, sizeof y);
    std::memcpy(B.one[r], one, sizeof one);
  }
  return B;
}

// det B(z), lowest power first. Eq. (25) to (28).
FRAMEWISE_INLINE void determinant(const HiddenVariable& B, double (&p)[11]) {
  for (double& coefficient : p) coefficient = 0;
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3, t = (r + 2) % 3;
    double minor[7] = {};
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
#pragma GCC unroll 4
      for (int j = 0; j < 4; ++j) minor[i + j] += B.x[s][i] * B.y[t][j] - B.x[t][i] * B.y[s][j];
    }
#pragma GCC unroll 7
    for (int i = 0; i < 7; ++i) {
#pragma GCC unroll 5
      for (int j = 0; j < 5; ++j) p[i + j] += minor[i] * B.one[r][j];
    }
  }
}

// (x, y, z, w) of a root: the null vector of B(z), as the cross product of the two rows that differ most.
FRAMEWISE_INLINE V4 back_substitute(const HiddenVariable& B, const ProjectiveRoot& root) {
  const double z = root.z, w = root.w;
  const double z2 = z * z, zw = z * w, w2 = w * w;
  double rows[3][3];
  for (int r = 0; r < 3; ++r) {
    const double *x = B.x[r], *y = B.y[r], *one = B.one[r];
    rows[r][0] = z2 * (x[3] * z + x[2] * w) + w2 * (x[1] * z + x[0] * w);
    rows[r][1] = z2 * (y[3] * z + y[2] * w) + w2 * (y[1] * z + y[0] * w);
    rows[r][2] = z2 * (one[4] * z2 + one[3] * zw + one[2] * w2) + w2 * (one[1] * zw + one[0] * w2);
  }
  const V4 xy1 = widest_cross(rows);
  return V4{xy1[0], xy1[1], xy1[2] * z, xy1[2] * w};
}

FRAMEWISE_INLINE int solve_nister(const Points& points, Motion (&motions)[10]) {
  Basis basis = null_space(points);
  align(points, basis);
  Constraints system = constraints(basis);
  int slots[10];
  double pivots[10];
  if (!eliminate(system, kNisterOrder, slots, pivots)) return 0;
  const HiddenVariable B = hide_z(system, slots, pivots);
  double p[11];
  determinant(B, p);
  const RealRoots<10> roots(p);
  const PointLanes by_lanes = lanes(points);
  int count = 0;
  for (int i = 0; i < roots.size() && count < 10; ++i) {
    Motion motion;
    if (!motion_of(basis, back_substitute(B, roots[i]), motion)) continue;
    if (polish(by_lanes, motion)) motions[count++] = motion;
  }
  return count;
}

}  // namespace framewise::five_point::FRAMEWISE_ISA
