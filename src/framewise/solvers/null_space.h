// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace framewise {

// Orthonormal basis of the 9 - N directions orthogonal to the N columns of A, by Householder QR: A = Q R, the
// last columns of Q (Golub and Van Loan, Matrix Computations, section 5.2). It is exact for an A that differs
// from the given one by rounding, also where the columns of A are dependent (then it is a part of the space).
template <int N>
Eigen::Matrix<double, 9, 9 - N> null_space(Eigen::Matrix<double, 9, N> A) {
  double scale[N];  // of the reflection I - scale v v', v in A's column k from row k downwards
  for (int k = 0; k < N; ++k) {
    double tail = 0;
    for (int i = k + 1; i < 9; ++i) tail += A(i, k) * A(i, k);
    const double norm = std::sqrt(A(k, k) * A(k, k) + tail);
    if (norm == 0) {
      scale[k] = 0;
      continue;
    }
    A(k, k) += std::copysign(norm, A(k, k));
    scale[k] = 1.0 / (norm * std::abs(A(k, k)));
    for (int j = k + 1; j < N; ++j) {
      double dot = 0;
      for (int i = k; i < 9; ++i) dot += A(i, k) * A(i, j);
      dot *= scale[k];
      for (int i = k; i < 9; ++i) A(i, j) -= dot * A(i, k);
    }
  }
  Eigen::Matrix<double, 9, 9 - N> basis = Eigen::Matrix<double, 9, 9 - N>::Zero();
  for (int j = 0; j < 9 - N; ++j) {
    basis(N + j, j) = 1;
    for (int k = N - 1; k >= 0; --k) {
      double dot = 0;
      for (int i = k; i < 9; ++i) dot += A(i, k) * basis(i, j);
      dot *= scale[k];
      for (int i = k; i < 9; ++i) basis(i, j) -= dot * A(i, k);
    }
  }
  return basis;
}

// The coefficients of vec(E) (column-major) in x2' E x1 = 0.
inline Eigen::Matrix<double, 9, 1> epipolar_row(const Eigen::Vector3d& x1, const Eigen::Vector3d& x2) {
  Eigen::Matrix<double, 9, 1> row;
  row << x1.x() * x2, x1.y() * x2, x1.z() * x2;
  return row;
}

}  // namespace framewise
