// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/solvers/eigenvalues_kernel.h"
#include "framewise/solvers/five_point_kernel.h"

// Stewenius, Engels, Nister, Recent developments on direct relative orientation, ISPRS Journal 2006.
namespace framewise::five_point::FRAMEWISE_ISA {

// All monomials of degree three in x, y, z are pivots; those with x first: they are the well-determined ones
// where the parallax is small (see align). The other ten are the basis of the quotient ring:
//   xx xy yy xz yz zz x y z 1.
inline constexpr int kSteweniusOrder[20] = {0,  1,  2,  4,  5,  7,  3,  6,  8,  9,
                                            10, 11, 12, 13, 14, 15, 16, 17, 18, 19};
// Where the pivots xxz xyz yyz xzz yzz zzz stand: z times the first six of the basis.
inline constexpr int kTimesZ[6] = {3, 4, 7, 5, 8, 9};

// z times the basis, modulo the constraints: row i gives z * basis[i] in the basis. The eigenvalues are the
// values of z.
FRAMEWISE_INLINE void action_matrix(const Constraints& system, const int (&slots)[10],
                                    const double (&pivots)[10], double (&M)[10][10]) {
  std::memset(M, 0, sizeof M);
  for (int r = 0; r < 6; ++r) {
    const double inverse = -1 / pivots[kTimesZ[r]];
    for (int c = 0; c < 10; ++c) M[r][c] = inverse * element(system.column[10 + c], slots[kTimesZ[r]]);
  }
  M[6][3] = M[7][4] = M[8][5] = M[9][8] = 1;
}

// (x, y, z, 1) of an eigenvalue. The six dense rows of M - z are linear in xx, xy, yy, x, y, 1 once z is
// known; the first three are eliminated, and (x, y, 1) is the cross product of the two rows that differ most.
FRAMEWISE_INLINE V4 back_substitute(const double (&M)[10][10], double z) {
  V4 columns[6][2]{};  // of xx, xy, yy, x, y, 1; six lanes are rows
  for (int r = 0; r < 6; ++r) {
    const int h = r / 4, lane = r % 4;
    columns[0][h][lane] = M[r][0];
    columns[1][h][lane] = M[r][1];
    columns[2][h][lane] = M[r][2];
    columns[3][h][lane] = M[r][3] * z + M[r][6];
    columns[4][h][lane] = M[r][4] * z + M[r][7];
    columns[5][h][lane] = (M[r][5] * z + M[r][8]) * z + M[r][9];
  }
  columns[0][0][0] -= z;  // z xx, z xy, z yy, z xz, z yz, z zz
  columns[1][0][1] -= z;
  columns[2][0][2] -= z;
  columns[3][0][3] -= z * z;
  columns[4][1][0] -= z * z;
  columns[5][1][1] -= z * z * z;
  V4 unused[2] = {{1, 1, 1, 1}, {1, 1, 0, 0}};
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const int slot = pivot_slot(columns[i], unused);
    const double inverse = 1 / element(columns[i], slot);
    reinterpret_cast<double*>(unused)[slot] = 0;
    const V4 m0 = columns[i][0] * inverse, m1 = columns[i][1] * inverse;
#pragma GCC unroll 6
    for (int j = i + 1; j < 6; ++j) {
      const double head = element(columns[j], slot);
      columns[j][0] -= m0 * head;
      columns[j][1] -= m1 * head;
    }
  }
  double rows[3][3];
  for (int r = 0; r < 3; ++r) {
    const int slot = pivot_slot(unused, unused);
    reinterpret_cast<double*>(unused)[slot] = 0;
    for (int c = 0; c < 3; ++c) rows[r][c] = element(columns[3 + c], slot);
  }
  const V4 xy1 = widest_cross(rows);
  return V4{xy1[0], xy1[1], xy1[2] * z, xy1[2]};
}

FRAMEWISE_INLINE int solve_stewenius(const Points& points, Motion (&motions)[10]) {
  Basis basis = null_space(points);
  align(points, basis);
  Constraints system = constraints(basis);
  int slots[10];
  double pivots[10];
  if (!eliminate(system, kSteweniusOrder, slots, pivots)) return 0;
  double M[10][10];
  action_matrix(system, slots, pivots, M);
  const Eigenvalues<10> eigenvalues(M);
  const PointLanes by_lanes = lanes(points);
  int count = 0;
  for (int i = 0; i < eigenvalues.size() && count < 10; ++i) {
    // Of two real solutions that nearly meet rounding may make a complex pair: both are sought beside it.
    const double imaginary = eigenvalues.imaginary(i), z = eigenvalues.real(i) + imaginary;
    const bool nearly_meet = imaginary != 0;
    if (!(std::abs(imaginary) <= kNearlyReal * (1 + std::abs(z)))) continue;
    Motion motion;
    if (!motion_of(basis, back_substitute(M, z), motion) || !polish(by_lanes, motion)) continue;
    if (nearly_meet && contains(motions, count, motion)) continue;
    motions[count++] = motion;
  }
  return count;
}

}  // namespace framewise::five_point::FRAMEWISE_ISA
