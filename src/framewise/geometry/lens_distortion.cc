// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/lens_distortion.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace framewise {

using Eigen::Matrix2d;
using Eigen::Vector2d;

RadialPolynomial brown_polynomial(const DistortionCoefficients& d) { return {d[0], d[1], d[4], 0}; }

RadialPolynomial fisheye_polynomial(const DistortionCoefficients& d) { return {d[0], d[1], d[2], d[3]}; }

Distorted distort_brown(const DistortionCoefficients& d, const Vector2d& x) {
  const RadialPolynomial f = brown_polynomial(d);
  const double p1 = d[2], p2 = d[3];
  const double r2 = x.squaredNorm(), xy = x.x() * x.y();
  const Vector2d tangential(2 * p1 * xy + p2 * (r2 + 2 * x.x() * x.x()),
                            p1 * (r2 + 2 * x.y() * x.y()) + 2 * p2 * xy);
  Matrix2d J_tangential;
  J_tangential << 2 * p1 * x.y() + 6 * p2 * x.x(), 2 * p1 * x.x() + 2 * p2 * x.y(),  //
      2 * p1 * x.x() + 2 * p2 * x.y(), 6 * p1 * x.y() + 2 * p2 * x.x();
  return {f.value(r2) * x + tangential,
          f.value(r2) * Matrix2d::Identity() + 2 * f.derivative(r2) * x * x.transpose() + J_tangential};
}

// Newton from the distorted point itself. The residual is squared every step; it has converged when it no
// longer falls and is at rounding level.
std::optional<Vector2d> undistort_brown(const DistortionCoefficients& d, const Vector2d& distorted) {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * (1 + distorted.norm());
  Vector2d x = distorted, best = x;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    const Distorted at = distort_brown(d, x);
    const Vector2d residual = at.x - distorted;
    const double size = residual.norm();
    if (size < least) {
      least = size;
      best = x;
    } else if (least <= rounding) {
      break;
    }
    if (size == 0) break;
    x -= at.J.inverse() * residual;
  }
  if (!(least <= rounding) || !brown_polynomial(d).grows_until(best.squaredNorm()) ||
      !(distort_brown(d, best).J.determinant() > 0))
    return std::nullopt;
  return best;
}

std::optional<double> undistort_fisheye(const DistortionCoefficients& d, double r) {
  const RadialPolynomial f = fisheye_polynomial(d);
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * (1 + r);
  double theta = r, best = r;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    const double residual = theta * f.value(theta * theta) - r;
    if (std::abs(residual) < least) {
      least = std::abs(residual);
      best = theta;
    } else if (least <= rounding) {
      break;
    }
    if (residual == 0) break;
    theta -= residual / f.growth(theta * theta);
  }
  if (!(least <= rounding) || best < 0 || best > M_PI || !f.grows_until(best * best)) return std::nullopt;
  return best;
}

}  // namespace framewise
