// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "framewise/geometry/epipolar.h"

namespace framewise {
namespace {

MeetingRays meet_on_plane(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2) {
  const Eigen::Matrix3d E = essential_from_pose(cam2_from_cam1);
  const Eigen::Matrix2d E22 = E.topLeftCorner<2, 2>();
  const Eigen::Vector2d n1 = (E.transpose() * x2).head<2>(), n2 = (E * x1).head<2>();
  const double c = x2.dot(E * x1);
  // Moves both points along the constraint's gradient m, exactly onto it; then takes m where they arrived.
  Eigen::Vector2d m1 = n1, m2 = n2, d1(0, 0), d2(0, 0);
  for (int iteration = 0; iteration < 5; ++iteration) {
    const double a = m2.dot(E22 * m1), b = 0.5 * (n1.dot(m1) + n2.dot(m2));
    const double lambda = c / (b + std::sqrt(std::max(0.0, b * b - a * c)));
    const Eigen::Vector2d before = d1;
    d1 = -lambda * m1;
    d2 = -lambda * m2;
    if ((d1 - before).squaredNorm() <= 1e-24 * d1.squaredNorm()) break;
    m1 = n1 + E22.transpose() * d2;
    m2 = n2 + E22 * d1;
  }
  if (c == 0) d1.setZero(), d2.setZero();
  return {{x1.x() + d1.x(), x1.y() + d1.y(), 1},
          {x2.x() + d2.x(), x2.y() + d2.y(), 1},
          d1.squaredNorm() + d2.squaredNorm()};
}

MeetingRays meet_on_sphere(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2) {
  // The epipolar plane's normal n = B y minimises (n . R x1)^2 + (n . x2)^2 over the normals of t.
  const Eigen::Matrix<double, 3, 2> B = sphere_tangent(cam2_from_cam1.t);
  const Eigen::Vector3d p = cam2_from_cam1.R * x1;
  const Eigen::Vector2d a = B.transpose() * p, b = B.transpose() * x2;
  const Eigen::Matrix2d M = a * a.transpose() + b * b.transpose();
  const double m = 0.5 * (M(0, 0) - M(1, 1)), h = std::hypot(m, M(0, 1));
  Eigen::Vector2d y = m >= 0 ? Eigen::Vector2d(-M(0, 1), m + h) : Eigen::Vector2d(h - m, -M(0, 1));
  if (!(y.squaredNorm() > 0)) y = {1, 0};
  const Eigen::Vector3d n = B * y.normalized();
  const double area = a.x() * b.y() - a.y() * b.x(), largest = 0.5 * M.trace() + h;
  return {(cam2_from_cam1.R.transpose() * (p - n * n.dot(p))).normalized(), (x2 - n * n.dot(x2)).normalized(),
          largest > 0 ? area * area / largest : 0};
}

}  // namespace

std::optional<TriangulatedPoint> triangulate_midpoint(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1,
                                                      const Eigen::Vector3d& x2) {
  const Eigen::Vector3d &t = cam2_from_cam1.t, p = cam2_from_cam1.R * x1.normalized(), q = x2.normalized();
  const Eigen::Vector3d n = q.cross(p);
  const double sine2 = n.squaredNorm();
  if (!(sine2 > 1e-30)) return std::nullopt;
  TriangulatedPoint point;
  point.lambda1 = t.cross(q).dot(n) / sine2;
  point.lambda2 = t.cross(p).dot(n) / sine2;
  const Eigen::Vector3d middle = 0.5 * (point.lambda1 * p + t + point.lambda2 * q);
  point.X1 = cam2_from_cam1.R.transpose() * (middle - t);
  point.parallax = std::atan2(std::sqrt(sine2), p.dot(q));
  return point;
}

MeetingRays nearest_meeting_rays(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1,
                                 const Eigen::Vector3d& x2, ImageSurface surface) {
  const Pose unit{cam2_from_cam1.R, cam2_from_cam1.t.normalized()};
  return surface == ImageSurface::kPlane ? meet_on_plane(unit, x1, x2) : meet_on_sphere(unit, x1, x2);
}

std::optional<TriangulatedPoint> triangulate_optimal(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1,
                                                     const Eigen::Vector3d& x2, ImageSurface surface) {
  if (!(cam2_from_cam1.t.squaredNorm() > 0)) return std::nullopt;
  const bool plane = surface == ImageSurface::kPlane;
  const MeetingRays rays = nearest_meeting_rays(cam2_from_cam1, x1 / (plane ? x1.z() : x1.norm()),
                                                x2 / (plane ? x2.z() : x2.norm()), surface);
  return triangulate_midpoint(cam2_from_cam1, rays.x1, rays.x2);
}

double parallax(const Eigen::Matrix3d& R, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2) {
  const Eigen::Vector3d p = R * x1;
  return std::atan2(p.cross(x2).norm(), p.dot(x2));
}

}  // namespace framewise
