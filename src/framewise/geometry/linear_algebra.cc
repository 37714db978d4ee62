// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace framewise {
namespace {

template <int N>
SymmetricEigen<N> decompose(const Eigen::Matrix<double, N, N>& S) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigen(S);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace

SymmetricEigen<3> symmetric_eigen(const Eigen::Matrix3d& S) { return decompose<3>(S); }

SymmetricEigen<6> symmetric_eigen(const Eigen::Matrix<double, 6, 6>& S) { return decompose<6>(S); }

SymmetricEigen<9> symmetric_eigen(const Eigen::Matrix<double, 9, 9>& S) { return decompose<9>(S); }

template <int N>
Cholesky<N>::Cholesky(const Matrix& S) {
  const Eigen::LLT<Matrix> llt(S);
  L_ = llt.matrixLLT();
  positive_definite_ = llt.info() == Eigen::Success;
}

template <int N>
typename Cholesky<N>::Vector Cholesky<N>::solve(const Vector& b) const {
  Vector x = b;
  L_.template triangularView<Eigen::Lower>().solveInPlace(x);
  L_.template triangularView<Eigen::Lower>().transpose().solveInPlace(x);
  return x;
}

template <int N>
typename Cholesky<N>::Matrix Cholesky<N>::inverse_of_factor() const {
  Matrix inverse = Matrix::Identity();
  L_.template triangularView<Eigen::Lower>().solveInPlace(inverse);
  return inverse;
}

template <int N>
typename Cholesky<N>::Matrix Cholesky<N>::inverse() const {
  const Matrix K = inverse_of_factor();
  return K.transpose() * K;
}

template class Cholesky<3>;
template class Cholesky<5>;
template class Cholesky<6>;
template class Cholesky<9>;

}  // namespace framewise
