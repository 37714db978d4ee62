// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "framewise/geometry/image_surface.h"
#include "framewise/geometry/pose.h"

// Two views of one point: x2 ~ R x1 + t / depth, so x2' E x1 = 0 with E = [t]x R.
// Every residual can give its derivative with respect to the tangent of the pose cam2_from_cam1:
// columns (rotation, translation), R exp(rotation) and t + translation. Where only the direction of t is
// known, multiply the last three columns by sphere_tangent(t). No function checks its input: they are inner
// loops.
namespace framewise {

using Jacobian16 = Eigen::Matrix<double, 1, 6>;
using Jacobian26 = Eigen::Matrix<double, 2, 6>;

// E = [t]x R
Eigen::Matrix3d essential_from_pose(const Pose& cam2_from_cam1);

// Two orthonormal columns, both normal to t: the tangent plane of the sphere of directions at t.
Eigen::Matrix<double, 3, 2> sphere_tangent(const Eigen::Vector3d& t);

// t moved along the great circle that leaves along sphere_tangent(t) * step, by |step| rad; |t| = 1.
Eigen::Vector3d sphere_exp(const Eigen::Vector3d& t, const Eigen::Vector2d& step);

// x2' E x1, in whatever unit x1, x2 and t have.
double algebraic_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                          Jacobian16* jacobian = nullptr);

// Angle (rad, signed) between the ray x2 and the epipolar plane spanned by t and R x1.
double epipolar_plane_angle(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                            Jacobian16* jacobian = nullptr);

// First-order distance of (x1, x2) to the pairs that satisfy x2' E x1 = 0: x2' E x1 over the length of its
// gradient on the surface. On the plane x1.z = x2.z = 1; on the sphere |x1| = |x2| = 1. Unit as ImageSurface.
//   Sampson; Hartley and Zisserman, Multiple View Geometry, 2nd ed., Eq. (11.9).
double sampson_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& x1, const Eigen::Vector3d& x2,
                        ImageSurface surface, Jacobian16* jacobian = nullptr);

// Where the point X1 (in camera 1) appears on plane z = 1 of camera 2, minus where it was seen, x2 / x2.z.
// The point must not lie in the plane z = 0 of camera 2; behind it the value has no meaning.
Eigen::Vector2d reprojection_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& X1,
                                      const Eigen::Vector3d& x2, Jacobian26* jacobian = nullptr);

// The same on the sphere: in the tangent plane at x2 (|x2| = 1), as long as the angle (rad) between x2 and
// the point's bearing.
Eigen::Vector2d bearing_angle_residual(const Pose& cam2_from_cam1, const Eigen::Vector3d& X1,
                                       const Eigen::Vector3d& x2, Jacobian26* jacobian = nullptr);

}  // namespace framewise
