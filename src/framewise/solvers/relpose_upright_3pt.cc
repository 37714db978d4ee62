// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/relpose_upright_3pt.h"

#include <Eigen/Geometry>
#include <cmath>

#include "framewise/geometry/so3.h"
#include "framewise/solvers/polynomial_roots.h"

namespace framewise {
namespace {

using Three = std::array<Bearing, 3>;

// A turn about the y axis.
struct Turn {
  double c, s;  // cosine and sine

  Eigen::Vector3d operator*(const Eigen::Vector3d& x) const {
    return {c * x.x() + s * x.z(), x.y(), c * x.z() - s * x.x()};
  }
  Turn operator*(const Turn& first) const { return {c * first.c - s * first.s, c * first.s + s * first.c}; }
  Eigen::Matrix3d matrix() const {
    Eigen::Matrix3d R;
    R << c, 0, s, 0, 1, 0, -s, 0, c;
    return R;
  }
  static Turn from_half_tangent(double q) {
    const double scale = 1 / (1 + q * q);
    return {(1 - q * q) * scale, 2 * q * scale};
  }
};

// The turn about y that takes the bearings x1 nearest to x2, and how near: what a baseline of this size can
// hide.
struct NearestTurn {
  Turn R;
  Three f;       // R x1
  double scale;  // rad, of half the turns still to be expected

  NearestTurn(const Three& x1, const Three& x2) {
    double cosine = 0, sine = 0, rest = 0;
    for (int i = 0; i < 3; ++i) {
      cosine += x1[i].x() * x2[i].x() + x1[i].z() * x2[i].z();
      sine += x1[i].z() * x2[i].x() - x1[i].x() * x2[i].z();
    }
    const double inverse = 1 / std::sqrt(cosine * cosine + sine * sine);
    R = {cosine * inverse, sine * inverse};
    for (int i = 0; i < 3; ++i) {
      f[i] = R * x1[i];
      rest += (x2[i] - f[i]).squaredNorm();
    }
    scale = std::sqrt(rest / 12);
  }
};

// Coordinates of the three normals, a point a row, in the frame half way, as polynomials in u,
// tan(angle / 2) = scale u: a0 + a1 u, b0 + b1 u and (1 - scale^2 u^2) c0 + 2 u c1, up to common factors of a
// column.
struct Normals {
  double scale2;
  Eigen::Vector3d a0, a1, b0, b1, c0, c1;

  Normals(const NearestTurn& nearest, const Three& x2) : scale2(nearest.scale * nearest.scale) {
    const double inverse = 1 / nearest.scale;
    for (int i = 0; i < 3; ++i) {
      const Bearing &f = nearest.f[i], &g = x2[i];
      a0[i] = (g.y() * f.x() - f.y() * g.x()) * inverse;
      a1[i] = g.y() * f.z() + f.y() * g.z();
      b0[i] = (g.y() * f.z() - f.y() * g.z()) * inverse;
      b1[i] = -g.y() * f.x() - f.y() * g.x();
      c0[i] = (f.z() * g.x() - f.x() * g.z()) * inverse;
      c1[i] = -f.x() * g.x() - f.z() * g.z();
    }
  }

  // The determinant [a b c] as c[0] + ... + c[4] u^4.
  std::array<double, 5> determinant() const {
    const Eigen::Vector3d d0 = a0.cross(b0), d1 = a0.cross(b1) + a1.cross(b0), d2 = a1.cross(b1);
    const double p00 = d0.dot(c0), p10 = d1.dot(c0), p20 = d2.dot(c0);
    const double p01 = 2 * d0.dot(c1), p11 = 2 * d1.dot(c1), p21 = 2 * d2.dot(c1);
    return {p00, p10 + p01, p20 + p11 - scale2 * p00, p21 - scale2 * p10, -scale2 * p20};
  }

  // Newton's method on the determinant before it is multiplied out.
  double polish(double u) const {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = a0 + u * a1, b = b0 + u * b1;
      const Eigen::Vector3d c = (1 - scale2 * u * u) * c0 + 2 * u * c1;
      const Eigen::Vector3d d = a.cross(b);
      const double slope = (a1.cross(b) + a.cross(b1)).dot(c) + 2 * d.dot(c1 - scale2 * u * c0);
      const double step = d.dot(c) / slope;
      if (!std::isfinite(step)) break;
      u -= step;
      if (std::abs(step) < 1e-8 * (1 + std::abs(u))) break;
    }
    return u;
  }
};

// The real roots of c[0] + ... + c[4] u^4. A small motion has one near infinity (half a turn) and may have
// one near zero, so the unknown is 1 / (u - k) with k where the polynomial is large.
Hypotheses<double, 4> roots_of(const std::array<double, 5>& c) {
  double k = 0, value = c[0];
  for (const double other : {0.6, -0.6, 1.7, -1.7}) {
    const double at = c[0] + other * (c[1] + other * (c[2] + other * (c[3] + other * c[4])));
    if (std::abs(at) > std::abs(value)) k = other, value = at;
  }
  std::array<double, 5> p = c;  // Taylor shift: coefficients in u - k
  for (int i = 0; i < 4; ++i)
    for (int j = 3; j >= i; --j) p[j] += k * p[j + 1];
  const double inverse = 1 / p[0];
  if (!std::isfinite(inverse)) return {};
  auto roots = quartic_roots(p[1] * inverse, p[2] * inverse, p[3] * inverse, p[4] * inverse);
  for (double& root : roots) root = k + 1 / root;
  return roots;
}

// The direction orthogonal to the three normals, from the two that determine it best; zero when none do.
Eigen::Vector3d direction(const Three& x1, const Three& x2, const Turn& R) {
  Eigen::Vector3d n[3], parallax = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d h = R * x1[i];
    n[i] = h.cross(x2[i]);
    parallax += x2[i] - h;
  }
  const Eigen::Vector3d candidates[3] = {n[0].cross(n[1]), n[1].cross(n[2]), n[2].cross(n[0])};
  const double norms2[3] = {candidates[0].squaredNorm(), candidates[1].squaredNorm(),
                            candidates[2].squaredNorm()};
  const int first = norms2[1] > norms2[0], k = norms2[2] > norms2[first] ? 2 : first;
  const Eigen::Vector3d& best = candidates[k];
  const double norm = std::sqrt(norms2[k]);
  if (!(norm > 1e-28)) return Eigen::Vector3d::Zero();
  // t.(x2 - R x1) = (lambda1 + lambda2) (1 - cos(parallax)): every point in front says plus.
  return best * std::copysign(1 / norm, best.dot(parallax));
}

}  // namespace

Hypotheses<Pose, 4> relpose_upright_3pt(const Three& x1, const Three& x2) {
  Hypotheses<Pose, 4> poses;
  const NearestTurn nearest(x1, x2);
  if (!(nearest.scale > 1e-14)) return poses;  // no parallax: any translation does
  const Normals normals(nearest, x2);
  for (const double root : roots_of(normals.determinant())) {
    const double q = nearest.scale * normals.polish(root);
    const Turn R = Turn::from_half_tangent(q) * nearest.R;
    const Eigen::Vector3d t = direction(x1, x2, R);
    if (t.squaredNorm() > 0.5) poses.push_back({R.matrix(), t});
  }
  return poses;
}

Hypotheses<Pose, 4> relpose_upright_3pt(const Three& x1, const Three& x2, const Bearing& gravity1,
                                        const Bearing& gravity2) {
  const Eigen::Matrix3d level1 = rotation_between(gravity1.normalized(), Bearing::UnitY());
  const Eigen::Matrix3d level2 = rotation_between(gravity2.normalized(), Bearing::UnitY());
  auto poses = relpose_upright_3pt({level1 * x1[0], level1 * x1[1], level1 * x1[2]},
                                   {level2 * x2[0], level2 * x2[1], level2 * x2[2]});
  for (Pose& pose : poses) pose = {level2.transpose() * pose.R * level1, level2.transpose() * pose.t};
  return poses;
}

}  // namespace framewise
