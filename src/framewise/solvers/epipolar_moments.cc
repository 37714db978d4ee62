// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/epipolar_moments.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix93 = Eigen::Matrix<double, 9, 3>;

// The matrices B with x2' B x1 = v . (x2 x R x1), row by row, for v = the three axes: B = -[v]x R.
Matrix93 normals(const Eigen::Matrix3d& R) {
  Matrix93 B;
  B.col(0) << 0, 0, 0, R.row(2).transpose(), -R.row(1).transpose();
  B.col(1) << -R.row(2).transpose(), 0, 0, 0, R.row(0).transpose();
  B.col(2) << R.row(1).transpose(), -R.row(0).transpose(), 0, 0, 0;
  return B;
}

}  // namespace

EpipolarMoments::EpipolarMoments(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                 std::span<const double> weights) {
  double sum[45] = {};  // upper triangle, row by row
  for (std::size_t i = 0; i < x1.size(); ++i) {
    const double w = weights.empty() ? 1.0 : weights[i];
    double v[9];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) v[3 * r + c] = x2[i][r] * x1[i][c];
    int n = 0;
    for (int r = 0; r < 9; ++r) {
      const double wv = w * v[r];
      for (int c = r; c < 9; ++c) sum[n++] += wv * v[c];
    }
  }
  int n = 0;
  for (int r = 0; r < 9; ++r)
    for (int c = r; c < 9; ++c) C_(r, c) = C_(c, r) = sum[n++];
}

EpipolarMoments::Value EpipolarMoments::evaluate(const Eigen::Matrix3d& R) const {
  const Matrix93 B = normals(R);
  const Eigen::Matrix3d M = B.transpose() * (C_.lazyProduct(B));
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(M);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

EpipolarMoments::Derivatives EpipolarMoments::derivatives(const Eigen::Matrix3d& R,
                                                          const Value& value) const {
  const Matrix93 B = normals(R);
  const Matrix93 CB = C_.lazyProduct(B);
  const Eigen::Vector3d t = value.eigenvectors.col(0);
  const Vector9 Ct = CB * t;
  const Eigen::Matrix3d W = Eigen::Map<const RowMajor3>(Ct.data());  // d(t'Mt)/dB / 2

  // dB/dw_a = -[t]x [e_a]x R = [t]x (B of axis a)
  const Eigen::Matrix3d T = skew(t);
  Matrix93 D;
  for (int a = 0; a < 3; ++a) {
    const RowMajor3 Da = T * Eigen::Map<const RowMajor3>(B.col(a).data());
    D.col(a) = Eigen::Map<const Vector9>(Da.data());
  }
  // Contractions of W with -[v]x X R, X any matrix: trace(Z_v X).
  const Eigen::Matrix3d RW = R * W.transpose();
  const auto axial = [](const Eigen::Matrix3d& Z) {  // trace(Z [e_a]x) for the three axes
    return Eigen::Vector3d(Z(1, 2) - Z(2, 1), Z(2, 0) - Z(0, 2), Z(0, 1) - Z(1, 0));
  };
  const Eigen::Matrix3d Z = -RW * T;

  Derivatives d;
  d.gradient = 2 * axial(Z);
  d.hessian = 2 * (D.transpose().lazyProduct(C_.lazyProduct(D).eval())) + Z + Z.transpose();
  d.hessian.diagonal().array() -= 2 * Z.trace();
  // The eigenvector follows the rotation: second-order perturbation of an eigenvalue.
  for (int k = 1; k < 3; ++k) {
    const Eigen::Vector3d v = value.eigenvectors.col(k);
    const Eigen::Vector3d coupling = D.transpose() * (CB * v) - axial(RW * skew(v));
    const double gap = value.eigenvalues[k] - value.eigenvalues[0];
    d.hessian -= (2 / std::max(gap, 1e-300)) * coupling * coupling.transpose();
  }
  return d;
}

Eigen::Matrix3d EpipolarMoments::linear_solution(double& residual) const {
  // Inverse iteration; the shift keeps a singular C (exact data) positive definite.
  Matrix9 shifted = C_;
  shifted.diagonal().array() += 1e-15 * C_.trace();
  const Eigen::LDLT<Matrix9> ldlt(shifted);
  Vector9 e = Vector9::Constant(1.0 / 3);
  e[1] = -e[1], e[5] = -0.7 * e[5];  // orthogonal to no usual solution
  for (int i = 0; i < 3; ++i) e = ldlt.solve(e).normalized();
  residual = e.dot(C_ * e);
  return Eigen::Map<const RowMajor3>(e.data());
}

}  // namespace framewise
