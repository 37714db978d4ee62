// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace framewise {

// Eigenvalues of a small real matrix and, on demand, the first K entries of a real eigenvector: what an
// action matrix is asked for. Golub and Van Loan, Matrix Computations (4th ed.), 7.4.2 (Hessenberg form, here
// by stabilised elimination, 7.4.7), 7.5 (Francis steps), 7.6.1 (inverse iteration).
template <int N, int K>
class SmallEigenvalues {
 public:
  // A is overwritten by its Hessenberg form. False when the iteration does not end (or A is not finite).
  bool compute(double (&A)[N][N]) {
    reduce(A);
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) H_[i][j] = A[i][j];
    return francis(A);
  }

  double real(int i) const { return real_[i]; }
  double imag(int i) const { return imag_[i]; }

  // The first K entries of the eigenvector of lambda, up to a factor: one step of inverse iteration.
  void eigenvector(double lambda, double (&head)[K]) const;

 private:
  void reduce(double (&A)[N][N]);
  bool francis(double (&A)[N][N]);
  void francis_step(double (&A)[N][N], int low, int high, double trace, double determinant);
  // row -= y other, from column m on
  static void subtract(double* __restrict row, double y, const double* __restrict other, int m) {
    for (int j = m; j < N; ++j) row[j] -= y * other[j];
  }
  void take_pair(double a, double b, double c, double d, int i);

  double H_[N][N];
  double basis_[K][N];  // first rows of T, T^-1 A T = H
  double real_[N], imag_[N];
};

template <int N, int K>
void SmallEigenvalues<N, K>::reduce(double (&A)[N][N]) {
  for (int i = 0; i < K; ++i)
    for (int j = 0; j < N; ++j) basis_[i][j] = i == j;
  for (int m = 1; m + 1 < N; ++m) {
    int pivot = m;
    for (int i = m + 1; i < N; ++i)
      if (std::abs(A[i][m - 1]) > std::abs(A[pivot][m - 1])) pivot = i;
    if (pivot != m) {
      for (int j = m - 1; j < N; ++j) std::swap(A[pivot][j], A[m][j]);
      for (int i = 0; i < N; ++i) std::swap(A[i][pivot], A[i][m]);
      for (int i = 0; i < K; ++i) std::swap(basis_[i][pivot], basis_[i][m]);
    }
    if (A[m][m - 1] == 0) continue;
    double factor[N] = {};
    const double inverse = 1 / A[m][m - 1];
    for (int i = m + 1; i < N; ++i) {
      const double y = A[i][m - 1] * inverse;
      factor[i] = y;
      A[i][m - 1] = 0;
      if (y == 0) continue;
      subtract(A[i], y, A[m], m);
    }
    // Column m takes what the columns behind it lose.
    const auto gather = [&](double(&row)[N]) {
      double even = 0, odd = 0;
      for (int j = (m + 1) / 2 * 2; j + 1 < N; j += 2)
        even += factor[j] * row[j], odd += factor[j + 1] * row[j + 1];
      row[m] += even + odd + (N % 2 ? factor[N - 1] * row[N - 1] : 0);
    };
    for (int i = 0; i < N; ++i) gather(A[i]);
    for (int i = 0; i < K; ++i) gather(basis_[i]);
  }
}

// Eigenvalues i and i + 1: those of [a b; c d].
template <int N, int K>
void SmallEigenvalues<N, K>::take_pair(double a, double b, double c, double d, int i) {
  const double half = 0.5 * (a - d), mean = 0.5 * (a + d), discriminant = half * half + b * c;
  if (discriminant < 0) {
    real_[i] = real_[i + 1] = mean;
    imag_[i] = std::sqrt(-discriminant), imag_[i + 1] = -imag_[i];
    return;
  }
  const double far = half + std::copysign(std::sqrt(discriminant), half);
  real_[i] = d + far, real_[i + 1] = far == 0 ? d : d - b * c / far;
  imag_[i] = imag_[i + 1] = 0;
}

template <int N, int K>
bool SmallEigenvalues<N, K>::francis(double (&A)[N][N]) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  int high = N - 1;
  for (int iteration = 0; high >= 0;) {
    int low = high;
    for (; low > 0; --low)
      if (std::abs(A[low][low - 1]) <= kEps * (std::abs(A[low - 1][low - 1]) + std::abs(A[low][low]))) break;
    if (low == high) {
      real_[high] = A[high][high], imag_[high] = 0;
      --high, iteration = 0;
    } else if (low == high - 1) {
      take_pair(A[low][low], A[low][high], A[high][low], A[high][high], low);
      high -= 2, iteration = 0;
    } else {
      if (++iteration > 100) return false;  // 40 to 60 are met once in 30,000
      const double a = A[high - 1][high - 1], b = A[high - 1][high], c = A[high][high - 1], d = A[high][high];
      double trace = a + d, determinant = a * d - b * c;
      if (iteration % 10 == 0) {  // a shift from elsewhere ends a cycle
        const double w = std::abs(c) + std::abs(A[high - 1][high - 2]);
        trace = 1.5 * w, determinant = w * w;
      }
      francis_step(A, low, high, trace, determinant);
    }
  }
  return true;
}

// One double-shift step on rows and columns low..high. Golub and Van Loan, algorithm 7.5.1.
template <int N, int K>
void SmallEigenvalues<N, K>::francis_step(double (&A)[N][N], int low, int high, double trace,
                                          double determinant) {
  double x = A[low][low] * (A[low][low] - trace) + A[low][low + 1] * A[low + 1][low] + determinant;
  double y = A[low + 1][low] * (A[low][low] + A[low + 1][low + 1] - trace);
  double z = A[low + 1][low] * A[low + 2][low + 1];
  for (int k = low; k < high; ++k) {
    const bool three = k + 2 <= high;
    if (!three) z = 0;
    const double norm = std::sqrt(x * x + y * y + z * z);
    if (norm > 0) {
      const double alpha = -std::copysign(norm, x);
      // P = I - beta (1, v1, v2)(1, v1, v2)'
      const double beta = (alpha - x) / alpha, scale = 1 / (x - alpha);
      const double v1 = y * scale, v2 = z * scale;
      double* __restrict r0 = A[k];
      double* __restrict r1 = A[k + 1];
      if (k > low) r0[k - 1] = alpha, r1[k - 1] = 0;
      if (three) {
        double* __restrict r2 = A[k + 2];
        if (k > low) r2[k - 1] = 0;
        for (int j = k; j <= high; ++j) {
          const double p = beta * (r0[j] + v1 * r1[j] + v2 * r2[j]);
          r0[j] -= p, r1[j] -= v1 * p, r2[j] -= v2 * p;
        }
        const int last = std::min(k + 3, high);
        for (int i = low; i <= last; ++i) {
          double* c = A[i] + k;
          const double p = beta * (c[0] + v1 * c[1] + v2 * c[2]);
          c[0] -= p, c[1] -= v1 * p, c[2] -= v2 * p;
        }
      } else {
        for (int j = k; j <= high; ++j) {
          const double p = beta * (r0[j] + v1 * r1[j]);
          r0[j] -= p, r1[j] -= v1 * p;
        }
        for (int i = low; i <= high; ++i) {
          double* c = A[i] + k;
          const double p = beta * (c[0] + v1 * c[1]);
          c[0] -= p, c[1] -= v1 * p;
        }
      }
    }
    x = A[k + 1][k];
    if (k + 2 <= high) y = A[k + 2][k];
    z = k + 3 <= high ? A[k + 3][k] : 0;
  }
}

template <int N, int K>
void SmallEigenvalues<N, K>::eigenvector(double lambda, double (&head)[K]) const {
  // U of the pivoted LU decomposition of H - lambda I, a row at a time.
  double U[N][N], row[N], norm = 0;
  for (int j = 0; j < N; ++j) row[j] = H_[0][j] - (j == 0 ? lambda : 0), norm += std::abs(H_[0][j]);
  const double tiny = std::numeric_limits<double>::epsilon() * (norm + std::abs(lambda)) + 1e-300;
  for (int k = 0; k + 1 < N; ++k) {
    double next[N];
    for (int j = k; j < N; ++j) next[j] = H_[k + 1][j];
    next[k + 1] -= lambda;
    double* upper = row;
    double* lower = next;
    if (std::abs(next[k]) > std::abs(row[k])) std::swap(upper, lower);
    if (upper[k] == 0) upper[k] = tiny;
    const double factor = lower[k] / upper[k];
    for (int j = k; j < N; ++j) U[k][j] = upper[j];
    for (int j = k + 1; j < N; ++j) row[j] = lower[j] - factor * upper[j];
  }
  U[N - 1][N - 1] = row[N - 1] == 0 ? tiny : row[N - 1];
  // U y = (1, ..., 1)': y grows along the eigenvector.
  double y[N];
  for (int i = N - 1; i >= 0; --i) {
    double sum = 1;
    for (int j = i + 1; j < N; ++j) sum -= U[i][j] * y[j];
    y[i] = sum / U[i][i];
  }
  for (int i = 0; i < K; ++i) {
    head[i] = 0;
    for (int j = 0; j < N; ++j) head[i] += basis_[i][j] * y[j];
  }
}

}  // namespace framewise
