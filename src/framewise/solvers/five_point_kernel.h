// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "framewise/solvers/five_point_types.h"

// What the five-point solvers share: the space of matrices with x2' E x1 = 0, the cubic constraints on it,
// elimination, and the polishing of a motion on the five equations themselves. Plain doubles and four-wide
// vectors.
//
// Included once by each source that makes a kernel, in that kernel's own namespace (FRAMEWISE_ISA): code for
// one instruction set never meets code for another under one name. Everything is inlined into its kernel, so
// no vector crosses a call and the warning about that is void.
#pragma GCC diagnostic ignored "-Wpsabi"
#define FRAMEWISE_INLINE inline __attribute__((always_inline))

namespace framewise::five_point::FRAMEWISE_ISA {

using V4 = double __attribute__((vector_size(32)));
using I4 = std::int64_t __attribute__((vector_size(32)));

// E = x X + y Y + z Z + w W: element (i, j) is e[3 j + i], its four lanes those of X, Y, Z, W (orthonormal).
struct Basis {
  V4 e[9];
};

FRAMEWISE_INLINE void cross(const double* a, const double* b, double* c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}
FRAMEWISE_INLINE double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The null space of the five equations, by Householder QR (Golub and Van Loan, Matrix Computations,
// section 5.2): exact for bearings that differ by rounding, for repeated and collinear points too.
FRAMEWISE_INLINE Basis null_space(const Points& points) {
  V4 A[9];         // row r, points 0 to 3
  double last[9];  // and point 4
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 4; ++k) A[3 * j + i][k] = points.x1[k][j] * points.x2[k][i];
      last[3 * j + i] = points.x1[4][j] * points.x2[4][i];
    }
  }
  double v[5][9], scale[5];  // reflections I - scale v v'
#pragma GCC unroll 5
  for (int k = 0; k < 5; ++k) {
    V4 dot{};
    double dot_last = 0;
#pragma GCC unroll 9
    for (int r = k; r < 9; ++r) {
      v[k][r] = k < 4 ? A[r][k & 3] : last[r];
      dot += v[k][r] * A[r];
      dot_last += v[k][r] * last[r];
    }
    const double norm2 = k < 4 ? dot[k & 3] : dot_last;
    const double norm = std::copysign(std::sqrt(norm2), v[k][k]);
    scale[k] = norm2 > 0 ? 1 / (norm2 + norm * v[k][k]) : 0;
    dot = (dot + norm * A[k]) * scale[k];
    dot_last = (dot_last + norm * last[k]) * scale[k];
    v[k][k] += norm;
#pragma GCC unroll 9
    for (int r = k + 1; r < 9; ++r) {
      A[r] -= v[k][r] * dot;
      last[r] -= v[k][r] * dot_last;
    }
  }
  Basis basis{};
  for (int lane = 0; lane < 4; ++lane) basis.e[5 + lane][lane] = 1;
#pragma GCC unroll 5
  for (int k = 4; k >= 0; --k) {
    V4 dot{};
#pragma GCC unroll 9
    for (int r = k; r < 9; ++r) dot += v[k][r] * basis.e[r];
    dot *= scale[k];
#pragma GCC unroll 9
    for (int r = k; r < 9; ++r) basis.e[r] -= v[k][r] * dot;
  }
  return basis;
}

// Rotation that takes x1 to x2 for points 0 and 1, as well as a rotation can.
FRAMEWISE_INLINE void rotation_of_two(const Points& points, double (&R)[3][3]) {
  double frames[2][3][3];
  for (int view = 0; view < 2; ++view) {
    const double *a = (view == 0 ? points.x1 : points.x2)[0], *b = (view == 0 ? points.x1 : points.x2)[1];
    double(&F)[3][3] = frames[view];
    for (int i = 0; i < 3; ++i) {
      F[0][i] = a[i] + b[i];
      F[1][i] = a[i] - b[i];
    }
    cross(F[0], F[1], F[2]);
    for (double(&f)[3] : F) {
      const double norm2 = dot(f, f), inverse = norm2 > 0 ? 1 / std::sqrt(norm2) : 0;
      for (double& x : f) x *= inverse;
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R[i][j] = frames[1][0][i] * frames[0][0][j] + frames[1][1][i] * frames[0][1][j] +
                frames[1][2][i] * frames[0][2][j];
    }
  }
}

// Turns the basis so that X carries what tells the cameras' motion from a rotation R0.
//   Where the parallax is small, a part of size epsilon of the bearings, all [t]x R0 nearly satisfy the
//   equations:
// they are three dimensions of the four, every matrix in them is essential, and all cubic constraints are
// nearly multiples of the linear form that vanishes there. In a basis that ignores it, elimination divides by
// epsilon in every unknown, and the determinant by epsilon cubed. With that form as x the solutions have x ~
// epsilon, the columns of x are graded, and no digits are lost. The form is read off the symmetric part of E
// R0', zero for [t]x.
FRAMEWISE_INLINE void align(const Points& points, Basis& basis) {
  double R0[3][3];
  rotation_of_two(points, R0);
  V4 M[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      M[i][j] = basis.e[i] * R0[j][0] + basis.e[3 + i] * R0[j][1] + basis.e[6 + i] * R0[j][2];
    }
  }
  const V4 symmetric[6] = {2 * M[0][0],       2 * M[1][1],       2 * M[2][2],
                           M[0][1] + M[1][0], M[0][2] + M[2][0], M[1][2] + M[2][1]};
  V4 form = symmetric[0];
  double largest = -1;
  for (const V4& s : symmetric) {
    const V4 squares = s * s;
    const double norm2 = (squares[0] + squares[1]) + (squares[2] + squares[3]);
    if (norm2 > largest) {
      largest = norm2;
      form = s;
    }
  }
  if (!(largest > 0)) return;
  // The reflection that takes the form to an axis.
  const double norm = std::copysign(std::sqrt(largest), form[0]);
  const double scale = 1 / (largest + norm * form[0]);
  form[0] += norm;
  for (V4& e : basis.e) {
    const V4 products = e * form;
    e -= form * (scale * ((products[0] + products[1]) + (products[2] + products[3])));
  }
}

// Index of a monomial in (x, y, z, w), graded reverse lexicographic:
//   xx xy yy xz yz zz xw yw zw ww, and xxx xxy xyy yyy xxz xyz yyz xzz yzz zzz xxw xyw yyw xzw yzw zzw xww
//   yww zww www.
inline constexpr int kQuadratic[4][4] = {{0, 1, 3, 6}, {1, 2, 4, 7}, {3, 4, 5, 8}, {6, 7, 8, 9}};
inline constexpr int kCubic[10][4] = {{0, 1, 4, 10},    {1, 2, 5, 11},   {2, 3, 6, 12},    {4, 5, 7, 13},
                                      {5, 6, 8, 14},    {7, 8, 9, 15},   {10, 11, 13, 16}, {11, 12, 14, 17},
                                      {13, 14, 15, 18}, {16, 17, 18, 19}};

FRAMEWISE_INLINE void add_product(V4 (&quadratic)[10], const V4 (&a)[4], const double (&b)[4], double sign) {
#pragma GCC unroll 4
  for (int j = 0; j < 4; ++j) {
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) quadratic[kQuadratic[i][j]] += a[i] * (sign * b[j]);
  }
}

template <typename Linear>
FRAMEWISE_INLINE void add_product(V4 (&cubic)[20], const V4 (&a)[10], const Linear (&b)[4]) {
#pragma GCC unroll 4
  for (int j = 0; j < 4; ++j) {
#pragma GCC unroll 10
    for (int i = 0; i < 10; ++i) cubic[kCubic[i][j]] += a[i] * b[j];
  }
}

// Ten cubic equations, stored by columns: twelve slots (the lanes of three vectors) hold the rows, two stay
// zero.
inline constexpr int kSlots = 12;
struct Constraints {
  V4 column[20][3];
};

// E E' E - 1/2 trace(E E') E = 0 and det E = 0 (Nister, Eq. (4) and (5)).
FRAMEWISE_INLINE Constraints constraints(const Basis& basis) {
  double E[3][3][4];   // [i][j]: linear forms
  V4 columns[3][4]{};  // [j]: lanes are the rows i
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      std::memcpy(E[i][j], &basis.e[3 * j + i], sizeof(V4));
      for (int m = 0; m < 4; ++m) columns[j][m][i] = E[i][j][m];
    }
  }
  // G[k]: lanes are the rows of E E' in column k; then of E E' - 1/2 trace(E E') I.
  V4 G[3][10]{};
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) add_product(G[k], columns[j], E[k][j], 1);
  }
  for (int q = 0; q < 10; ++q) {
    const double half_trace = 0.5 * (G[0][q][0] + G[1][q][1] + G[2][q][2]);
    G[0][q] -= V4{half_trace, 0, 0, 0};
    G[1][q] -= V4{0, half_trace, 0, 0};
    G[2][q] -= V4{0, 0, half_trace, 0};
  }
  Constraints result{};
  for (int j = 0; j < 3; ++j) {
    V4 cubic[20]{};
    for (int k = 0; k < 3; ++k) add_product(cubic, G[k], E[k][j]);
    for (int c = 0; c < 20; ++c) result.column[c][j] = cubic[c];
  }
  // det E = column 0 . (column 1 x column 2), lanes are the terms.
  V4 cofactor[10]{}, terms[20]{};
#pragma GCC unroll 4
  for (int n = 0; n < 4; ++n) {
    const V4 b1{E[1][2][n], E[2][2][n], E[0][2][n], 0}, b2{E[2][2][n], E[0][2][n], E[1][2][n], 0};
#pragma GCC unroll 4
    for (int m = 0; m < 4; ++m) {
      const V4 a1{E[1][1][m], E[2][1][m], E[0][1][m], 0}, a2{E[2][1][m], E[0][1][m], E[1][1][m], 0};
      cofactor[kQuadratic[m][n]] += a1 * b2 - a2 * b1;
    }
  }
  add_product(terms, cofactor, columns[0]);
  for (int c = 0; c < 20; ++c) result.column[c][0] += V4{0, 0, 0, terms[c][0] + terms[c][1] + terms[c][2]};
  return result;
}

// The slot in which |column| is largest among those not yet used (their mask is 1, others 0).
template <int Vectors>
FRAMEWISE_INLINE int pivot_slot(const V4 (&column)[Vectors], const V4 (&unused)[Vectors]) {
  // The slot's number replaces the last four bits of |x| (without a sign, doubles order as integers do), so
  // that one maximum finds both.
  constexpr std::int64_t kMagnitude = 0x7ffffffffffffff0;
  V4 best{};
#pragma GCC unroll 3
  for (int k = 0; k < Vectors; ++k) {
    const I4 slot{4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3};
    const V4 tagged = (V4)(((I4)(column[k] * unused[k]) & kMagnitude) | slot);
    best = tagged > best ? tagged : best;
  }
  const double low = best[0] > best[1] ? best[0] : best[1], high = best[2] > best[3] ? best[2] : best[3];
  const double top = low > high ? low : high;
  std::int64_t bits;
  std::memcpy(&bits, &top, sizeof bits);
  return static_cast<int>(bits & 15);
}

FRAMEWISE_INLINE double element(const V4* column, int slot) {
  return reinterpret_cast<const double*>(column)[slot];
}

// Gauss-Jordan elimination, partial pivoting, no row moves: after it, slot slots[i] holds the row whose pivot
// is column order[i], and pivots[i] its pivot. Returns false when the columns are dependent.
FRAMEWISE_INLINE bool eliminate(Constraints& system, const int (&order)[20], int (&slots)[10],
                                double (&pivots)[10]) {
  V4 unused[3] = {{1, 1, 1, 1}, {1, 1, 1, 0}, {1, 1, 1, 0}};
  bool regular = true;
#pragma GCC unroll 1
  for (int i = 0; i < 10; ++i) {
    V4(&column)[3] = system.column[order[i]];
    const int slot = pivot_slot(column, unused);
    const double pivot = element(column, slot);
    slots[i] = slot;
    pivots[i] = pivot;
    regular &= std::abs(pivot) > 1e-30;
    reinterpret_cast<double*>(unused)[slot] = 0;
    reinterpret_cast<double*>(column)[slot] = 0;
    const double inverse = 1 / pivot;
    const V4 m0 = column[0] * inverse, m1 = column[1] * inverse, m2 = column[2] * inverse;
#pragma GCC unroll 1
    for (int j = i + 1; j < 20; ++j) {
      V4(&other)[3] = system.column[order[j]];
      const double head = element(other, slot);
      other[0] -= m0 * head;
      other[1] -= m1 * head;
      other[2] -= m2 * head;
    }
  }
  return regular;
}

// The five points by lanes (three of eight stay zero).
struct PointLanes {
  V4 x1[3][2], x2[3][2];
};

FRAMEWISE_INLINE PointLanes lanes(const Points& points) {
  PointLanes result{};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 5; ++i) {
      result.x1[k][i / 4][i % 4] = points.x1[i][k];
      result.x2[k][i / 4][i % 4] = points.x2[i][k];
    }
  }
  return result;
}

// Unit vector orthogonal to three rows that are nearly dependent: the cross product of the two that differ
// most.
FRAMEWISE_INLINE V4 widest_cross(const double (&rows)[3][3]) {
  double crosses[3][3], largest = -1;
  int best = 0;
  for (int k = 0; k < 3; ++k) {
    cross(rows[k], rows[(k + 1) % 3], crosses[k]);
    const double norm2 = dot(crosses[k], crosses[k]);
    if (norm2 > largest) {
      largest = norm2;
      best = k;
    }
  }
  return V4{crosses[best][0], crosses[best][1], crosses[best][2], 0} * (1 / std::sqrt(largest));
}

// One of the motions of E = x X + y Y + z Z + w W, nearly essential. False where E is zero or not finite.
//   R = (cofactors of E) - [t]x E for |t| = 1: Horn, Recovering baseline and orientation from essential
//   matrix, 1990.
FRAMEWISE_INLINE bool motion_of(const Basis& basis, const V4& xyzw, Motion& motion) {
  // Columns of E and of its cofactors t (R' t)'.
  double e[3][3], c[3][3];
  double norm2 = 0;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const V4 terms = basis.e[3 * j + i] * xyzw;
      e[j][i] = (terms[0] + terms[1]) + (terms[2] + terms[3]);
      norm2 += e[j][i] * e[j][i];
    }
  }
  cross(e[1], e[2], c[0]);
  cross(e[2], e[0], c[1]);
  cross(e[0], e[1], c[2]);
  const double c2[3] = {dot(c[0], c[0]), dot(c[1], c[1]), dot(c[2], c[2])};
  const int largest = c2[0] >= c2[1] ? (c2[0] >= c2[2] ? 0 : 2) : (c2[1] >= c2[2] ? 1 : 2);
  if (!(c2[largest] > 1e-20 * norm2 * norm2) || !std::isfinite(norm2)) return false;
  const double inverse = 1 / std::sqrt(c2[largest]);
  for (int i = 0; i < 3; ++i) motion.t[i] = c[largest][i] * inverse;
  const double scale2 = 2 / norm2, scale = std::sqrt(scale2);  // |E| = sqrt(2)
  double r[2][3];                                              // columns 0 and 1 of R
  for (int j = 0; j < 2; ++j) {
    double te[3];
    cross(motion.t, e[j], te);
    for (int i = 0; i < 3; ++i) r[j][i] = scale2 * c[j][i] - scale * te[i];
  }
  double r2[3];
  const double n0 = 1 / std::sqrt(dot(r[0], r[0]));
  for (double& x : r[0]) x *= n0;
  const double d = dot(r[0], r[1]);
  for (int i = 0; i < 3; ++i) r[1][i] -= d * r[0][i];
  const double n1 = 1 / std::sqrt(dot(r[1], r[1]));
  for (double& x : r[1]) x *= n1;
  cross(r[0], r[1], r2);
  for (int i = 0; i < 3; ++i) {
    motion.R[i][0] = r[0][i];
    motion.R[i][1] = r[1][i];
    motion.R[i][2] = r2[i];
  }
  return true;
}

FRAMEWISE_INLINE double largest_magnitude(const V4 (&r)[2]) {
  double most = 0;
  for (int i = 0; i < 5; ++i) {
    const double magnitude = std::abs(element(r, i));
    most = magnitude <= most ? most : magnitude;  // NaN stays
  }
  return most;
}

// Rotation R <- Cayley(omega) R, t <- t + d0 B0 + d1 B1.
FRAMEWISE_INLINE void move(Motion& motion, const double (&step)[5], const double (&B)[2][3]) {
  const double a = 0.5 * step[0], b = 0.5 * step[1], c = 0.5 * step[2];
  const double s = 2 / (1 + a * a + b * b + c * c);
  // Of the unit quaternion (1, a, b, c) / norm.
  const double Q[3][3] = {{1 - s * (b * b + c * c), s * (a * b - c), s * (a * c + b)},
                          {s * (a * b + c), 1 - s * (a * a + c * c), s * (b * c - a)},
                          {s * (a * c - b), s * (b * c + a), 1 - s * (a * a + b * b)}};
  double R[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R[i][j] = Q[i][0] * motion.R[0][j] + Q[i][1] * motion.R[1][j] + Q[i][2] * motion.R[2][j];
    }
  }
  std::memcpy(motion.R, R, sizeof R);
  for (int i = 0; i < 3; ++i) motion.t[i] += step[3] * B[0][i] + step[4] * B[1][i];
  const double n = 1 / std::sqrt(dot(motion.t, motion.t));
  for (double& x : motion.t) x *= n;
}

// Two unit vectors orthogonal to t and to each other.
//   Duff et al., Building an orthonormal basis, revisited, JCGT 2017.
FRAMEWISE_INLINE void tangents(const double (&t)[3], double (&B)[2][3]) {
  const double sign = std::copysign(1.0, t[2]), a = -1 / (sign + t[2]), b = t[0] * t[1] * a;
  B[0][0] = 1 + sign * t[0] * t[0] * a, B[0][1] = sign * b, B[0][2] = -sign * t[0];
  B[1][0] = b, B[1][1] = sign + t[1] * t[1] * a, B[1][2] = -t[1];
}

// Solves the five equations J step = -r (J's columns and r in the given lanes): the rotation is eliminated,
// two equations remain for the translation. Where there is little parallax these say little; then the
// translation takes a bounded step and the rotation the best one for it. False where the step is not finite.
FRAMEWISE_INLINE bool newton_step(V4 (&J)[6][2], double (&step)[5]) {
  constexpr double kLongest = 0.3;  // rad: further, the linearisation says little
  V4 unused[2] = {{1, 1, 1, 1}, {1, 0, 0, 0}};
  int slots[5];
  double inverses[3];
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const int slot = slots[i] = pivot_slot(J[i], unused);
    inverses[i] = 1 / element(J[i], slot);
    reinterpret_cast<double*>(unused)[slot] = 0;
    reinterpret_cast<double*>(J[i])[slot] = 0;
    const V4 m0 = J[i][0] * inverses[i], m1 = J[i][1] * inverses[i];
#pragma GCC unroll 6
    for (int j = i + 1; j < 6; ++j) {
      const double head = element(J[j], slot);
      J[j][0] -= m0 * head;
      J[j][1] -= m1 * head;
    }
  }
  slots[3] = pivot_slot(J[3], unused);
  reinterpret_cast<double*>(unused)[slots[3]] = 0;
  slots[4] = pivot_slot(unused, unused);  // the one that is left
  const double a = element(J[3], slots[3]), b = element(J[4], slots[3]), r0 = element(J[5], slots[3]);
  const double c = element(J[3], slots[4]), d = element(J[4], slots[4]), r1 = element(J[5], slots[4]);
  const double determinant = a * d - b * c;
  const double d0 = b * r1 - d * r0, d1 = c * r0 - a * r1;
  const double length = std::sqrt(d0 * d0 + d1 * d1);
  const bool too_long = length > kLongest * std::abs(determinant);
  const double scale = !too_long    ? 1 / determinant
                       : length > 0 ? std::copysign(kLongest / length, determinant)
                                    : 0;
  step[3] = d0 * scale;
  step[4] = d1 * scale;
  double rotation2 = 0;
  for (int i = 0; i < 3; ++i) {
    step[i] = -inverses[i] * (element(J[5], slots[i]) + element(J[3], slots[i]) * step[3] +
                              element(J[4], slots[i]) * step[4]);
    rotation2 += step[i] * step[i];
  }
  if (rotation2 > kLongest * kLongest) {
    const double shorter = kLongest / std::sqrt(rotation2);
    for (double& x : step) x *= shorter;
  }
  return std::isfinite(rotation2) && std::isfinite(step[3]) && std::isfinite(step[4]);
}

inline constexpr double kNearlyReal = 1e-3;
inline constexpr int kMostSteps = 10;
inline constexpr double kSolved = 1e-11;  // of |x2' [t]x R x1|; what rounding leaves of a root is below 1e-15

// Newton's method on x2_i' [t]x R x1_i = 0, five equations in the five degrees of freedom of the motion. The
// elimination's digits do not matter here, only the root's own condition. False when no root is reached.
FRAMEWISE_INLINE bool polish(const PointLanes& points, Motion& motion) {
  const auto& b = points.x2;
  for (int step_count = 0;; ++step_count) {
    V4 a[3][2], n[3][2], r[2];
    for (int h = 0; h < 2; ++h) {
      for (int i = 0; i < 3; ++i) {
        a[i][h] = motion.R[i][0] * points.x1[0][h] + motion.R[i][1] * points.x1[1][h] +
                  motion.R[i][2] * points.x1[2][h];
      }
      n[0][h] = a[1][h] * b[2][h] - a[2][h] * b[1][h];
      n[1][h] = a[2][h] * b[0][h] - a[0][h] * b[2][h];
      n[2][h] = a[0][h] * b[1][h] - a[1][h] * b[0][h];
      r[h] = motion.t[0] * n[0][h] + motion.t[1] * n[1][h] + motion.t[2] * n[2][h];
    }
    const double residual = largest_magnitude(r);
    if (residual < 4e-16) return true;
    if (step_count == kMostSteps || !(residual < 1)) return residual < kSolved;

    double B[2][3];
    tangents(motion.t, B);
    V4 J[6][2];  // dr / d(omega, d0, d1), r
    for (int h = 0; h < 2; ++h) {
      const V4 bt0 = b[1][h] * motion.t[2] - b[2][h] * motion.t[1];
      const V4 bt1 = b[2][h] * motion.t[0] - b[0][h] * motion.t[2];
      const V4 bt2 = b[0][h] * motion.t[1] - b[1][h] * motion.t[0];
      J[0][h] = a[1][h] * bt2 - a[2][h] * bt1;
      J[1][h] = a[2][h] * bt0 - a[0][h] * bt2;
      J[2][h] = a[0][h] * bt1 - a[1][h] * bt0;
      J[3][h] = B[0][0] * n[0][h] + B[0][1] * n[1][h] + B[0][2] * n[2][h];
      J[4][h] = B[1][0] * n[0][h] + B[1][1] * n[1][h] + B[1][2] * n[2][h];
      J[5][h] = r[h];
    }
    double step[5];
    if (!newton_step(J, step)) return residual < kSolved;
    move(motion, step, B);
  }
}

// True when the motion's essential matrix is, up to sign and rounding, that of one of the first `count`.
FRAMEWISE_INLINE bool contains(const Motion* motions, int count, const Motion& motion) {
  double E[3][3];
  for (int j = 0; j < 3; ++j) {
    const double column[3] = {motion.R[0][j], motion.R[1][j], motion.R[2][j]};
    cross(motion.t, column, E[j]);
  }
  for (int m = 0; m < count; ++m) {
    double same = 0, opposite = 0;
    for (int j = 0; j < 3; ++j) {
      const double column[3] = {motions[m].R[0][j], motions[m].R[1][j], motions[m].R[2][j]};
      double e[3];
      cross(motions[m].t, column, e);
      for (int i = 0; i < 3; ++i) {
        same += (E[j][i] - e[i]) * (E[j][i] - e[i]);
        opposite += (E[j][i] + e[i]) * (E[j][i] + e[i]);
      }
    }
    if (same < 1e-14 || opposite < 1e-14) return true;
  }
  return false;
}

}  // namespace framewise::five_point::FRAMEWISE_ISA
