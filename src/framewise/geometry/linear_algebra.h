// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

// Eigen's decompositions in the few sizes that this project uses, compiled once: each takes a compiler
// seconds.
namespace framewise {

// S = vectors diag(values) vectors', the values in increasing order.
template <int N>
struct SymmetricEigen {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;  // in columns, orthonormal
};
SymmetricEigen<3> symmetric_eigen(const Eigen::Matrix3d& S);
SymmetricEigen<6> symmetric_eigen(const Eigen::Matrix<double, 6, 6>& S);
SymmetricEigen<9> symmetric_eigen(const Eigen::Matrix<double, 9, 9>& S);

// S = L L' of a symmetric positive definite matrix; N is 3, 5, 6 or 9.
template <int N>
class Cholesky {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  explicit Cholesky(const Matrix& S);

  bool positive_definite() const { return positive_definite_; }
  const Matrix& L() const { return L_; }  // what lies above its diagonal means nothing
  Vector solve(const Vector& b) const;    // S x = b
  Matrix inverse() const;                 // of S
  Matrix inverse_of_factor() const;       // of L

 private:
  Matrix L_;
  bool positive_definite_;
};

}  // namespace framewise
