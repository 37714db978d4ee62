// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/epipolar.h"

#include <Eigen/Geometry>
#include <cmath>

#include "framewise/geometry/so3.h"

namespace framewise {
namespace {

// Derivatives are easiest as W = R w, the turn seen in camera 2: d(R x1) = W x (R x1). Row for w: R' dW.
Jacobian16 row(const Eigen::Matrix3d& R, const Eigen::Vector3d& dW, const Eigen::Vector3d& dt) {
  Jacobian16 J;
  J << (R.transpose() * dW).transpose(), dt.transpose();
  return J;
}

}  // namespace

Eigen::Matrix3d essential_from_pose(const Pose& cam2_from_cam1) {
  return skew(cam2_from_cam1.t) * cam2_from_cam1.R;
}

Eigen::Matrix<double, 3, 2> sphere_tangent(const Eigen::Vector3d& t) {
  // The axis farthest from t keeps the cross product long.
  Eigen::Index axis;
  t.cwiseAbs().minCoeff(&axis);
  Eigen::Matrix<double, 3, 2> B;
  B.col(0) = t.cross(Eigen::Vector3d::Unit(axis)).normalized();
  B.col(1) = t.cross(B.col(0)).normalized();
  return B;
}

Eigen::Vector3d sphere_exp(const Eigen::Vector3d& t, const Eigen::Vector2d& step) {
  const double angle = step.norm();
  const double sinc = angle < 1e-8 ? 1.0 : std::sin(angle) / angle;
  return (std::cos(angle) * t + sinc * (sphere_tangent(t) * step)).normalized();
}

double algebraic_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                          Jacobian16* jacobian) {
  const Eigen::Vector3d p = cam2_from_cam1.R * x1, c = x2.cross(cam2_from_cam1.t);
  if (jacobian) *jacobian = row(cam2_from_cam1.R, p.cross(c), p.cross(x2));
  return c.dot(p);
}

double epipolar_plane_angle(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                            Jacobian16* jacobian) {
  const Eigen::Vector3d &t = cam2_from_cam1.t, p = cam2_from_cam1.R * x1, normal = t.cross(p);
  const double length = normal.norm();
  const Eigen::Vector3d n = normal / length, across = x2 - n * n.dot(x2);
  const double sine = n.dot(x2), cosine = across.norm();
  if (jacobian) {
    // d(angle) = across / |across| . dn, dn = (I - n n') d(t x p) / length
    const Eigen::Vector3d k = across / (cosine * length);
    *jacobian = row(cam2_from_cam1.R, p.cross(k.cross(t)), p.cross(k));
  }
  return std::atan2(sine, cosine);
}

double sampson_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                        ImageSurface surface, Jacobian16* jacobian) {
  const bool plane = surface == ImageSurface::kPlane;
  const Eigen::Matrix3d& R = cam2_from_cam1.R;
  const Eigen::Vector3d &t = cam2_from_cam1.t, p = R * x1;
  const Eigen::Vector3d l2 = t.cross(p), c = x2.cross(t);  // E x1 and R E' x2
  const double r = c.dot(p);
  // a, b: the gradients of r with respect to x2 and R x1 within their surfaces, whose normals are n2 and n1.
  const Eigen::Vector3d n2 = plane ? Eigen::Vector3d(0, 0, 1) : x2;
  const Eigen::Vector3d n1 = plane ? Eigen::Vector3d(R.col(2)) : p;
  const double k = n1.dot(c);
  const Eigen::Vector3d a = l2 - n2 * n2.dot(l2), b = c - n1 * k;
  const double D = a.squaredNorm() + b.squaredNorm(), length = std::sqrt(D);
  if (jacobian) {
    const Eigen::Vector3d half_dD_dW = p.cross(a.cross(t)) - k * n1.cross(c);
    const Eigen::Vector3d half_dD_dt = p.cross(a) + b.cross(x2);
    const double q = r / D;
    *jacobian = row(R, (p.cross(c) - q * half_dD_dW) / length, (p.cross(x2) - q * half_dD_dt) / length);
  }
  return r / length;
}

Eigen::Vector2d reprojection_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& X1,
                                      const Eigen::Vector3d& x2, Jacobian26* jacobian) {
  const Eigen::Vector3d p = cam2_from_cam1.R * X1, y = p + cam2_from_cam1.t;
  const double u = y.x() / y.z(), v = y.y() / y.z();
  if (jacobian) {
    const Eigen::Vector3d du(1 / y.z(), 0, -u / y.z()), dv(0, 1 / y.z(), -v / y.z());
    jacobian->row(0) = row(cam2_from_cam1.R, p.cross(du), du);
    jacobian->row(1) = row(cam2_from_cam1.R, p.cross(dv), dv);
  }
  return {u - x2.x() / x2.z(), v - x2.y() / x2.z()};
}

Eigen::Vector2d bearing_angle_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& X1,
                                       const Eigen::Vector3d& x2, Jacobian26* jacobian) {
  const Eigen::Vector3d p = cam2_from_cam1.R * X1, y = p + cam2_from_cam1.t;
  const double distance = y.norm();
  const Eigen::Vector3d b = y / distance;
  const Eigen::Matrix<double, 3, 2> B = sphere_tangent(x2);
  const Eigen::Vector2d s = B.transpose() * b;  // as long as the sine of the angle
  const double cosine = x2.dot(b), sine = s.norm(), angle = std::atan2(sine, cosine);
  const double stretch = sine < 1e-8 ? 1.0 : angle / sine;
  if (jacobian) {
    // d(stretch s) = stretch ds + s d(stretch); d(angle) = cosine d(sine) - sine d(cosine).
    Eigen::Matrix<double, 2, 3> db = stretch * B.transpose();
    if (sine >= 1e-8) {
      const Eigen::RowVector3d dsine = s.transpose() * B.transpose() / sine;
      const Eigen::RowVector3d dangle = cosine * dsine - sine * x2.transpose();
      db += s * ((dangle - stretch * dsine) / sine);
    }
    const Eigen::Matrix<double, 2, 3> dy = (db - db * b * b.transpose()) / distance;
    for (int i = 0; i < 2; ++i) jacobian->row(i) = row(cam2_from_cam1.R, p.cross(dy.row(i)), dy.row(i));
  }
  return stretch * s;
}

}  // namespace framewise
