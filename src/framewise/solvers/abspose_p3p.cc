// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/abspose_p3p.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "framewise/solvers/polynomial_roots.h"

namespace framewise {
namespace {

// Symmetric 3x3 matrix: the conic  xx x^2 + 2 xy x y + yy y^2 + 2 xw x + 2 yw y + ww = 0.
struct Conic {
  double xx, xy, xw, yy, yw, ww;

  Conic adjugate() const {
    return {yy * ww - yw * yw, xw * yw - xy * ww, xy * yw - xw * yy,
            xx * ww - xw * xw, xw * xy - xx * yw, xx * yy - xy * xy};
  }
  friend double trace_of_product(const Conic& a, const Conic& b) {
    return a.xx * b.xx + a.yy * b.yy + a.ww * b.ww + 2 * (a.xy * b.xy + a.xw * b.xw + a.yw * b.yw);
  }
  friend Conic combine(double s, const Conic& a, double t, const Conic& b) {
    return {s * a.xx + t * b.xx, s * a.xy + t * b.xy, s * a.xw + t * b.xw,
            s * a.yy + t * b.yy, s * a.yw + t * b.yw, s * a.ww + t * b.ww};
  }
};

struct DepthRatios {
  double x, y;  // lambda1 / lambda3, lambda2 / lambda3
};

// Where the line l.(x, y, 1) = 0 meets the conic, kept when both ratios are positive.
void intersect(const double (&l)[3], const Conic& c, Hypotheses<DepthRatios, 4>& ratios) {
  const bool solve_for_y = std::abs(l[1]) > std::abs(l[0]);
  // The free coordinate u is x (then y = m u + k) or y (then x = m u + k).
  const double inverse = -1 / (solve_for_y ? l[1] : l[0]);
  const double m = inverse * (solve_for_y ? l[0] : l[1]), k = inverse * l[2];
  const double uu = solve_for_y ? c.xx : c.yy, vv = solve_for_y ? c.yy : c.xx;
  const double uw = solve_for_y ? c.xw : c.yw, vw = solve_for_y ? c.yw : c.xw;
  const double a = uu + m * (2 * c.xy + m * vv);
  const double half_b = uw + m * (vw + k * vv) + k * c.xy;
  const double d0 = c.ww + k * (2 * vw + k * vv);
  const double discriminant = half_b * half_b - a * d0;
  // A double root (the camera on the danger cylinder) may round to just below zero.
  if (!(discriminant > -1e-12 * half_b * half_b)) return;
  const double q = -half_b - std::copysign(std::sqrt(std::max(discriminant, 0.0)), half_b);
  for (const double u : {q / a, d0 / q}) {
    const double v = m * u + k;
    if (u > 0 && v > 0) ratios.push_back(solve_for_y ? DepthRatios{u, v} : DepthRatios{v, u});
  }
}

int largest(const double (&v)[3]) {
  const int i = v[1] > v[0];
  return v[2] > v[i] ? 2 : i;
}

// The two lines of a degenerate conic: C + [p]x has rank one, p the point where they meet. False when the
// lines are complex: then the two conics of the pencil have no real point in common.
bool split(const Conic& C, double (&line1)[3], double (&line2)[3]) {
  const Conic B = C.adjugate();  // -p p'
  const double columns_of_B[3][3] = {{-B.xx, -B.xy, -B.xw}, {-B.xy, -B.yy, -B.yw}, {-B.xw, -B.yw, -B.ww}};
  const double diagonal[3] = {-B.xx, -B.yy, -B.ww};
  const int k = largest(diagonal);
  if (!(diagonal[k] > 0)) return false;
  const double scale = 1 / std::sqrt(diagonal[k]);
  const double p[3] = {scale * columns_of_B[k][0], scale * columns_of_B[k][1], scale * columns_of_B[k][2]};
  const double D[3][3] = {
      {C.xx, C.xy - p[2], C.xw + p[1]}, {C.xy + p[2], C.yy, C.yw - p[0]}, {C.xw - p[1], C.yw + p[0], C.ww}};
  double rows[3], columns[3];
  for (int i = 0; i < 3; ++i) {
    rows[i] = D[i][0] * D[i][0] + D[i][1] * D[i][1] + D[i][2] * D[i][2];
    columns[i] = D[0][i] * D[0][i] + D[1][i] * D[1][i] + D[2][i] * D[2][i];
  }
  const int row = largest(rows), column = largest(columns);
  for (int i = 0; i < 3; ++i) line1[i] = D[row][i], line2[i] = D[i][column];
  return true;
}

// The law of cosines for the three sides.
struct Triangle {
  double a12, a13, a23;  // squared sides
  double b12, b13, b23;  // cosines between the bearings

  // Gauss-Newton steps on the depths until the sides agree.
  void polish(Eigen::Vector3d& lambda) const {
    for (int i = 0; i < 4; ++i) {
      const double l1 = lambda[0], l2 = lambda[1], l3 = lambda[2];
      const double r12 = l1 * l1 + l2 * l2 - 2 * b12 * l1 * l2 - a12;
      const double r13 = l1 * l1 + l3 * l3 - 2 * b13 * l1 * l3 - a13;
      const double r23 = l2 * l2 + l3 * l3 - 2 * b23 * l2 * l3 - a23;
      const double mismatch = std::abs(r12) + std::abs(r13) + std::abs(r23);
      if (mismatch < 1e-13 * a13) return;
      const double j12_1 = l1 - b12 * l2, j12_2 = l2 - b12 * l1;  // half the derivatives
      const double j13_1 = l1 - b13 * l3, j13_3 = l3 - b13 * l1;
      const double j23_2 = l2 - b23 * l3, j23_3 = l3 - b23 * l2;
      const double half_inverse = 0.5 / (j12_1 * j13_3 * j23_2 + j12_2 * j13_1 * j23_3);
      const Eigen::Vector3d step(j13_3 * j23_2 * r12 + j12_2 * j23_3 * r13 - j12_2 * j13_3 * r23,
                                 j13_1 * j23_3 * r12 - j12_1 * j23_3 * r13 + j12_1 * j13_3 * r23,
                                 -j13_1 * j23_2 * r12 + j12_1 * j23_2 * r13 + j12_2 * j13_1 * r23);
      const Eigen::Vector3d next = lambda - half_inverse * step;
      if (!(next[0] > 0 && next[1] > 0 && next[2] > 0)) return;
      lambda = next;
      // Newton doubles the digits: after this step the sides agree to rounding.
      if (mismatch < 1e-8 * a13) return;
    }
  }
};

struct Pencil {
  double w1, w2;  // the conic w1 C1 + w2 C2
};

// A degenerate conic of the pencil: det(C1 + sigma C2) is a cubic in sigma.
Pencil degenerate(const Conic& C1, const Conic& C2) {
  const Conic B1 = C1.adjugate(), B2 = C2.adjugate();
  const double k0 = trace_of_product(C1, B1) / 3, k1 = trace_of_product(B1, C2);
  const double k2 = trace_of_product(C1, B2), k3 = trace_of_product(C2, B2) / 3;
  const double ends = std::max(std::abs(k0), std::abs(k3));
  if (ends < 1e-4 * std::max(std::abs(k1), std::abs(k2))) {
    // Both conics are degenerate themselves (an equilateral triangle seen straight on): C1 + sigma (C1 +-
    // C2).
    const double sign = k1 * k2 < 0 ? -1 : 1;
    const double inverse = 1 / (k0 + sign * k1 + k2 + sign * k3);
    const double sigma = outermost_cubic_root((3 * k0 + sign * 2 * k1 + k2) * inverse,
                                              (3 * k0 + sign * k1) * inverse, k0 * inverse);
    return {1 + sigma, sign * sigma};
  }
  if (std::abs(k3) < std::abs(k0)) {
    const double inverse = 1 / k0;
    return {outermost_cubic_root(k1 * inverse, k2 * inverse, k3 * inverse), 1};
  }
  const double inverse = 1 / k3;
  return {1, outermost_cubic_root(k2 * inverse, k1 * inverse, k0 * inverse)};
}

Hypotheses<DepthRatios, 4> depth_ratios(const Triangle& s) {
  Hypotheses<DepthRatios, 4> ratios;
  const double inverse = 1 / s.a13, a = s.a12 * inverse, b = s.a23 * inverse;
  const Conic C1{1 - a, -s.b12, a * s.b13, 1, 0, -a};
  const Conic C2{-b, 0, b * s.b13, 1, -s.b23, 1 - b};
  const Pencil w = degenerate(C1, C2);
  double line1[3], line2[3];
  if (!split(combine(w.w1, C1, w.w2, C2), line1, line2)) return ratios;
  const Conic& other = std::abs(w.w1) < std::abs(w.w2) ? C1 : C2;
  intersect(line1, other, ratios);
  intersect(line2, other, ratios);
  return ratios;
}

// v times a factor that is 1 / |v| up to a few digits, made a unit vector: a Newton step of the reciprocal
// root. Of flat triangles the area is not known to so many. Not finite where there is no direction.
Eigen::Vector3d unit(const Eigen::Vector3d& v, double inverse_length) {
  constexpr double kFewDigits = 1e-6;
  const Eigen::Vector3d u = v * inverse_length;
  const double square = u.squaredNorm();
  return std::abs(square - 1) < kFewDigits ? Eigen::Vector3d(u * (1.5 - 0.5 * square)) : v / v.norm();
}

// Frame of a triangle: unit vectors along edge a, in the triangle's plane, and along its normal a x b.
inline Eigen::Matrix3d frame(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double inverse_length,
                             double inverse_double_area) {
  Eigen::Matrix3d F;
  F.col(0) = unit(a, inverse_length);
  F.col(2) = unit(a.cross(b), inverse_double_area);
  F.col(1) = F.col(2).cross(F.col(0));
  return F;
}

}  // namespace

Hypotheses<Pose, 4> abspose_p3p(const std::array<Bearing, 3>& x, const std::array<Eigen::Vector3d, 3>& X) {
  Hypotheses<Pose, 4> poses;
  const Eigen::Vector3d X12 = X[1] - X[0], X13 = X[2] - X[0];
  const Triangle sides{X12.squaredNorm(), X13.squaredNorm(), (X[2] - X[1]).squaredNorm(),
                       x[0].dot(x[1]),    x[0].dot(x[2]),    x[1].dot(x[2])};
  const double double_area2 = X12.cross(X13).squaredNorm();
  constexpr double kLeastSine2 = 1e-14;  // a flatter triangle has no normal to speak of
  if (!(double_area2 > kLeastSine2 * sides.a12 * sides.a13)) return poses;
  const double inverse_length = 1 / std::sqrt(sides.a12), inverse_double_area = 1 / std::sqrt(double_area2);
  const Eigen::Matrix3d world = frame(X12, X13, inverse_length, inverse_double_area).transpose();

  for (const DepthRatios& ratio : depth_ratios(sides)) {
    const double lambda3 = std::sqrt(sides.a13 / (ratio.x * (ratio.x - 2 * sides.b13) + 1));
    Eigen::Vector3d lambda(ratio.x * lambda3, ratio.y * lambda3, lambda3);
    sides.polish(lambda);
    const Eigen::Vector3d Y1 = lambda[0] * x[0];
    Pose pose;
    // Polished, the triangle seen has the sides of the triangle given, and so its area.
    pose.R.noalias() =
        frame(lambda[1] * x[1] - Y1, lambda[2] * x[2] - Y1, inverse_length, inverse_double_area) * world;
    pose.t = Y1 - pose.R * X[0];
    if (pose.t.allFinite()) poses.push_back(pose);
  }
  return poses;
}

}  // namespace framewise
