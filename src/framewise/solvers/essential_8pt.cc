// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/essential_8pt.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/geometry/linear_algebra.h"
#include "framewise/solvers/decompose_essential.h"
#include "framewise/solvers/null_space.h"

namespace framewise {
namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;

Vector6d upper_products(const Eigen::Vector3d& x) {
  Vector6d p;
  p << x.x() * x, x.y() * x.y(), x.y() * x.z(), x.z() * x.z();
  return p;
}

constexpr int kUpper[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};  // index into upper_products

Eigen::Matrix3d unpack(const Vector6d& p) {
  Eigen::Matrix3d M;
  M << p(0), p(1), p(2), p(1), p(3), p(4), p(2), p(4), p(5);
  return M;
}

// T with sum w (T x)(T x)' = sum w I / 3; the identity where the bearings span less than 3 dimensions.
Eigen::Matrix3d whitening(const Eigen::Matrix3d& second_moment) {
  const Cholesky<3> cholesky(second_moment * (3 / second_moment.trace()));
  if (!cholesky.positive_definite() || !(cholesky.L().diagonal().minCoeff() > 1e-7)) {
    return Eigen::Matrix3d::Identity();
  }
  return cholesky.inverse_of_factor();
}

Eigen::Matrix3d solve_minimal(std::span<const Bearing> x1, std::span<const Bearing> x2,
                              std::span<const double> weights) {
  Eigen::Matrix<double, 9, 8> A;
  for (int i = 0; i < 8; ++i) {
    A.col(i) = epipolar_row(x1[i], x2[i]);
    if (!weights.empty()) A.col(i) *= std::sqrt(weights[i]);
  }
  const Vector9d e = null_space<8>(A);
  return Eigen::Map<const Eigen::Matrix3d>(e.data());
}

// The eigenvector of the smallest eigenvalue of M = sum w a a', by inverse iteration; gradient(e) is M e,
// from the points themselves. M has lost the digits below sqrt(eps) of the residuals; one step of first-order
// perturbation with that gradient gives them back.
template <typename Gradient>
Vector9d smallest_eigenvector(const Matrix9d& M, const Gradient& gradient) {
  Matrix9d shifted = M;  // eigenvectors stay, and exact data stay positive definite
  shifted.diagonal().array() += 1e-14 * M.trace();
  const Cholesky<9> cholesky(shifted);
  constexpr int kMostIterations = 20;
  Vector9d e = Vector9d::LinSpaced(1, -0.6).normalized();  // orthogonal to no usual solution
  for (int iteration = 0; cholesky.positive_definite() && iteration < kMostIterations; ++iteration) {
    const Vector9d next = cholesky.solve(e).normalized();
    const bool converged = (next - e).squaredNorm() < 1e-18;
    e = next;
    if (!converged) continue;
    const Vector9d g = gradient(e);
    const Vector9d step = cholesky.solve(g - e.dot(g) * e);
    return (e - (step - e.dot(step) * e)).normalized();
  }
  return symmetric_eigen(M).vectors.col(0);  // the two smallest are about equal
}

Eigen::Matrix3d solve_least_squares(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                    std::span<const double> weights) {
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  Vector6d moment1 = Vector6d::Zero(), moment2 = Vector6d::Zero();
  for (std::size_t i = 0; i < x1.size(); ++i) {
    moment1 += weight(i) * upper_products(x1[i]);
    moment2 += weight(i) * upper_products(x2[i]);
  }
  const Eigen::Matrix3d T1 = whitening(unpack(moment1)), T2 = whitening(unpack(moment2));

  // a a' = (x1 x1') (x) (x2 x2'), so 36 sums hold all 81.
  Matrix6d products = Matrix6d::Zero();
  for (std::size_t i = 0; i < x1.size(); ++i) {
    products += (weight(i) * upper_products(T2 * x2[i])) * upper_products(T1 * x1[i]).transpose();
  }
  Matrix9d M;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) M(i, j) = products(kUpper[i % 3][j % 3], kUpper[i / 3][j / 3]);
  }
  const Vector9d e = smallest_eigenvector(M, [&](const Vector9d& v) {
    Vector9d gradient = Vector9d::Zero();
    for (std::size_t i = 0; i < x1.size(); ++i) {
      const Vector9d a = epipolar_row(T1 * x1[i], T2 * x2[i]);
      gradient += (weight(i) * a.dot(v)) * a;
    }
    return gradient;
  });
  return T2.transpose() * Eigen::Map<const Eigen::Matrix3d>(e.data()) * T1;
}

}  // namespace

std::optional<Eigen::Matrix3d> essential_8pt(std::span<const Bearing> x1, std::span<const Bearing> x2,
                                             std::span<const double> weights) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("essential_8pt: " + what); };
  if (x1.size() != x2.size()) {
    refuse("x1 has " + std::to_string(x1.size()) + " bearings, x2 has " + std::to_string(x2.size()) +
           "; expected as many");
  }
  if (x1.size() < 8) refuse("x1 has " + std::to_string(x1.size()) + " bearings; expected at least 8");
  if (!weights.empty() && weights.size() != x1.size()) {
    refuse("weights has " + std::to_string(weights.size()) + " values; expected " +
           std::to_string(x1.size()) + " or none");
  }
  const Eigen::Matrix3d E =
      x1.size() == 8 ? solve_minimal(x1, x2, weights) : solve_least_squares(x1, x2, weights);
  if (!E.allFinite()) return std::nullopt;
  return nearest_essential(E);
}

}  // namespace framewise
