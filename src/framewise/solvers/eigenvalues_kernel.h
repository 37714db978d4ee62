// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "framewise/solvers/five_point_kernel.h"

namespace framewise::five_point::FRAMEWISE_ISA {

// Eigenvalues of a real N x N matrix, without the vectors: balancing, reduction to Hessenberg form, QR steps
// with two shifts. Golub and Van Loan, Matrix Computations, 4th ed., sections 7.4 and 7.5.
template <int N>
class Eigenvalues {
 public:
  FRAMEWISE_INLINE explicit Eigenvalues(const double (&A)[N][N]) {
    std::memcpy(H_, A, sizeof A);
    balance();
    to_hessenberg();
    iterate();
  }

  // Fewer than N where the iteration did not end (or met NaN).
  FRAMEWISE_INLINE int size() const { return size_; }
  FRAMEWISE_INLINE double real(int i) const { return real_[i]; }
  FRAMEWISE_INLINE double imaginary(int i) const { return imaginary_[i]; }

 private:
  // Scales unknowns by powers of 2 until rows and columns are of similar size.
  FRAMEWISE_INLINE void balance() {
    for (int sweep = 0; sweep < 4; ++sweep) {
      bool changed = false;
      for (int i = 0; i < N; ++i) {
        double row = 0, column = 0;
        for (int j = 0; j < N; ++j) {
          if (j == i) continue;
          row += std::abs(H_[i][j]);
          column += std::abs(H_[j][i]);
        }
        if (!(row > 0 && column > 0 && row < 1e300 && column < 1e300)) continue;
        const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
        if (factor > 0.6 && factor < 1.7) continue;
        changed = true;
        for (int j = 0; j < N; ++j) H_[j][i] *= factor;
        for (int j = 0; j < N; ++j) H_[i][j] /= factor;
      }
      if (!changed) return;
    }
  }

  // Gauss transformations with pivoting: half the work of reflections, and as good in practice.
  FRAMEWISE_INLINE void to_hessenberg() {
    for (int k = 0; k < N - 2; ++k) {
      int pivot = k + 1;
      for (int i = k + 2; i < N; ++i) {
        if (std::abs(H_[i][k]) > std::abs(H_[pivot][k])) pivot = i;
      }
      if (H_[pivot][k] == 0) continue;
      if (pivot != k + 1) {
        for (int j = k; j < N; ++j) swap(H_[pivot][j], H_[k + 1][j]);
        for (int i = 0; i < N; ++i) swap(H_[i][pivot], H_[i][k + 1]);
      }
      const double inverse = 1 / H_[k + 1][k];
      double multipliers[N];
      for (int i = k + 2; i < N; ++i) {
        multipliers[i] = H_[i][k] * inverse;
        H_[i][k] = 0;
        for (int j = k + 1; j < N; ++j) H_[i][j] -= multipliers[i] * H_[k + 1][j];
      }
      for (int i = 0; i < N; ++i) {
        double sum = H_[i][k + 1];
        for (int j = k + 2; j < N; ++j) sum += multipliers[j] * H_[i][j];
        H_[i][k + 1] = sum;
      }
    }
  }

  FRAMEWISE_INLINE void iterate() {
    int last = N - 1;
    for (int steps = 0; last >= 0;) {
      // The active block: rows first..last between two negligible subdiagonals.
      int first = last;
      while (first > 0) {
        const double scale = std::abs(H_[first][first]) + std::abs(H_[first - 1][first - 1]);
        if (std::abs(H_[first][first - 1]) <= kRounding * scale) break;
        --first;
      }
      if (first == last) {
        push(H_[last][last], 0);
        last -= 1;
        steps = 0;
      } else if (first == last - 1) {
        push_pair(last - 1);
        last -= 2;
        steps = 0;
      } else {
        if (++steps > 100) return;  // 40 to 60 are met once in 30,000
        francis_step(first, last, steps % 10 == 0);
      }
    }
  }

  // One implicit step with the two eigenvalues of the last 2 x 2 block as shifts (every tenth time: with
  // others, to leave a cycle). Section 7.5.1.
  FRAMEWISE_INLINE void francis_step(int first, int last, bool exceptional) {
    double trace = H_[last - 1][last - 1] + H_[last][last];
    double determinant = H_[last - 1][last - 1] * H_[last][last] - H_[last - 1][last] * H_[last][last - 1];
    if (exceptional) {
      const double size = std::abs(H_[last][last - 1]) + std::abs(H_[last - 1][last - 2]);
      trace = 1.5 * size;
      determinant = size * size;
    }
    double x = H_[first][first] * (H_[first][first] - trace) + determinant +
               H_[first][first + 1] * H_[first + 1][first];
    double y = H_[first + 1][first] * (H_[first][first] + H_[first + 1][first + 1] - trace);
    double z = H_[first + 1][first] * H_[first + 2][first + 1];
    for (int k = first; k < last; ++k) {
      const bool three = k + 2 <= last;
      if (!three) z = 0;
      const double largest = std::abs(x) + std::abs(y) + std::abs(z);
      if (largest > 0) {
        x /= largest, y /= largest, z /= largest;
        const double norm = std::copysign(std::sqrt(x * x + y * y + z * z), x);
        // Reflection I - (1, v1, v2)' tau (1, v1, v2).
        const double head = x + norm, v1 = y / head, v2 = z / head, tau = head / norm;
        const int from = k > first ? k - 1 : first;
        if (three) {
          for (int j = from; j < N; ++j) {
            const double sum = tau * (H_[k][j] + v1 * H_[k + 1][j] + v2 * H_[k + 2][j]);
            H_[k][j] -= sum;
            H_[k + 1][j] -= sum * v1;
            H_[k + 2][j] -= sum * v2;
          }
          const int to = k + 3 < last ? k + 3 : last;
          for (int i = 0; i <= to; ++i) {
            const double sum = tau * (H_[i][k] + v1 * H_[i][k + 1] + v2 * H_[i][k + 2]);
            H_[i][k] -= sum;
            H_[i][k + 1] -= sum * v1;
            H_[i][k + 2] -= sum * v2;
          }
        } else {
          for (int j = from; j < N; ++j) {
            const double sum = tau * (H_[k][j] + v1 * H_[k + 1][j]);
            H_[k][j] -= sum;
            H_[k + 1][j] -= sum * v1;
          }
          for (int i = 0; i <= last; ++i) {
            const double sum = tau * (H_[i][k] + v1 * H_[i][k + 1]);
            H_[i][k] -= sum;
            H_[i][k + 1] -= sum * v1;
          }
        }
        if (k > first) {  // the bulge that was chased away
          H_[k + 1][k - 1] = 0;
          if (three) H_[k + 2][k - 1] = 0;
        }
      }
      x = H_[k + 1][k];
      y = k + 2 <= last ? H_[k + 2][k] : 0;
      z = k + 3 <= last ? H_[k + 3][k] : 0;
    }
  }

  FRAMEWISE_INLINE void push(double real, double imaginary) {
    real_[size_] = real;
    imaginary_[size_] = imaginary;
    ++size_;
  }

  FRAMEWISE_INLINE void push_pair(int k) {
    const double half = 0.5 * (H_[k][k] - H_[k + 1][k + 1]), middle = 0.5 * (H_[k][k] + H_[k + 1][k + 1]);
    const double product = H_[k][k + 1] * H_[k + 1][k];
    const double discriminant = half * half + product;
    if (discriminant >= 0) {
      const double far = half + std::copysign(std::sqrt(discriminant), half);
      push(H_[k + 1][k + 1] + far, 0);
      push(far != 0 ? H_[k + 1][k + 1] - product / far : H_[k + 1][k + 1], 0);
    } else {
      push(middle, std::sqrt(-discriminant));
      push(middle, -std::sqrt(-discriminant));
    }
  }

  FRAMEWISE_INLINE static void swap(double& a, double& b) {
    const double old = a;
    a = b;
    b = old;
  }

  static constexpr double kRounding = 2.2e-16;
  double H_[N][N];
  double real_[N], imaginary_[N];
  int size_ = 0;
};

}  // namespace framewise::five_point::FRAMEWISE_ISA
